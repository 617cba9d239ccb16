// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "line_layer.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

LineLayer::LineLayer(const Frame& frame, float bias)
    : frame_(frame), bias_(bias), depth_(frame.depth.size(), Frame::kNothing),
      style_(frame.depth.size(), 0), tone_(frame.depth.size(), 255)
{
}

void LineLayer::dot(int x, int y, float d, std::uint8_t style, float tone)
{
  if (x < 0 || y < 0 || x >= frame_.width || y >= frame_.height)
    return;
  const std::size_t i = frame_.index(x, y);
  if (d + bias_ < frame_.depth[i] || d <= depth_[i])
    return;
  depth_[i] = d;
  style_[i] = style;
  tone_[i] = toByte(tone);
}

void LineLayer::line(const Eigen::Vector3f& a,
                     const Eigen::Vector3f& b,
                     std::uint8_t style,
                     float tone,
                     int width)
{
  const Eigen::Vector3f along = b - a;
  const bool steep = std::abs(along.y()) > std::abs(along.x());
  const float longest = std::max(std::abs(along.x()), std::abs(along.y()));
  if (!(longest < 1e5f)) // not a number, or absurd
    return;
  const int steps = std::max(1, static_cast<int>(std::ceil(longest)));
  for (int s = 0; s <= steps; ++s) {
    const Eigen::Vector3f p = a + along * (static_cast<float>(s) / steps);
    const float side = 0.5f * static_cast<float>(width - 1);
    const int x = static_cast<int>(std::floor(p.x() - (steep ? side : 0)));
    const int y = static_cast<int>(std::floor(p.y() - (steep ? 0 : side)));
    for (int k = 0; k < width; ++k)
      dot(steep ? x + k : x, steep ? y : y + k, p.z(), style, tone);
  }
}

void LineLayer::dashed(
    Eigen::Vector3f a, Eigen::Vector3f b, std::uint8_t style, int width, float dash)
{
  if (b.x() < a.x() || (b.x() == a.x() && b.y() < a.y()))
    std::swap(a, b);
  const float length = (b - a).head<2>().norm();
  if (!(length > 0.f && length < 1e5f))
    return;
  const float from = a.head<2>().dot((b - a).head<2>()) / length;
  const float period = 2 * dash;
  for (float dot = std::floor(from / period) * period; dot < from + length;
       dot += period) {
    const float begin = std::max(dot - from, 0.f);
    const float end = std::min(dot + dash - from, length);
    if (begin < end)
      line(a + (b - a) * (begin / length),
           a + (b - a) * (end / length),
           style,
           1.f,
           width);
  }
}

void LineLayer::clear()
{
  std::fill(depth_.begin(), depth_.end(), Frame::kNothing);
  std::fill(style_.begin(), style_.end(), std::uint8_t{0});
}

float LineLayer::coverage(std::uint8_t style) const
{
  constexpr int tile = 8 * Frame::kSuper;
  std::size_t found = 0, room = 0;
  for (int top = 0; top + tile <= frame_.height; top += tile)
    for (int left = 0; left + tile <= frame_.width; left += tile) {
      std::size_t here = 0;
      for (int y = top; y < top + tile; ++y)
        for (int x = left; x < left + tile; ++x)
          here += style_[frame_.index(x, y)] == style;
      found += here;
      room += here > 0 ? tile * tile : 0;
    }
  return room > 0 ? static_cast<float>(found) / static_cast<float>(room) : 0.f;
}

void LineLayer::copyTo(Raster& raster,
                       const Raster& lighting,
                       const std::vector<Style>& styles) const
{
  for (std::size_t i = 0; i < style_.size(); ++i) {
    if (style_[i] == 0)
      continue;
    const Style& style = styles[style_[i] - 1];
    Rgb colour = style.colour * (static_cast<float>(tone_[i]) / 255.f);
    if (style.lit && depth_[i] - frame_.depth[i] < 2 * bias_) {
      const Rgb under = lighting.pixels[i];
      // 1 on level ground, which the part's faint surface shows at 0.87.
      const float bright = (under.r + under.g + under.b) / (3.f * 0.87f);
      colour = colour * std::min(1.05f, 0.42f + 0.6f * bright * bright * bright);
    }
    raster.pixels[i] = mix(raster.pixels[i], colour, style.alpha);
  }
}

} // namespace pointmill::visual
