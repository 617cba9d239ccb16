// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas.h"

#include <cmath>

namespace pointmill::visual {

Canvas::Canvas(int width, int height, const Rgb& background)
    : width_(width), height_(height), clip_{0, 0, width, height},
      bytes_(static_cast<std::size_t>(width) * height * 3)
{
  fill({0, 0, width, height}, background);
}

void Canvas::clip(const Rect& rect)
{
  const int left = std::max(rect.x, 0), top = std::max(rect.y, 0);
  clip_ = {left,
           top,
           std::min(rect.right(), width_) - left,
           std::min(rect.bottom(), height_) - top};
}

void Canvas::set(int x, int y, const Rgb& colour)
{
  if (!inside(x, y))
    return;
  std::uint8_t* p = &bytes_[offset(x, y)];
  p[0] = toByte(colour.r);
  p[1] = toByte(colour.g);
  p[2] = toByte(colour.b);
}

void Canvas::blend(int x, int y, const Rgb& colour, float alpha)
{
  if (!inside(x, y) || alpha <= 0.f)
    return;
  const std::uint8_t* p = &bytes_[offset(x, y)];
  const Rgb old{
      static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  set(x, y, mix(old * (1.f / 255.f), colour, std::min(alpha, 1.f)));
}

void Canvas::fill(const Rect& rect, const Rgb& colour)
{
  for (int y = std::max(rect.y, 0); y < std::min(rect.bottom(), height_); ++y)
    for (int x = std::max(rect.x, 0); x < std::min(rect.right(), width_); ++x)
      set(x, y, colour);
}

void Canvas::fillRound(const Rect& rect, float radius, const Rgb& colour)
{
  const float hx = rect.width * 0.5f, hy = rect.height * 0.5f;
  for (int y = rect.y; y < rect.bottom(); ++y)
    for (int x = rect.x; x < rect.right(); ++x) {
      // Signed distance to the rounded outline.
      const float qx = std::abs(x + 0.5f - rect.x - hx) - hx + radius;
      const float qy = std::abs(y + 0.5f - rect.y - hy) - hy + radius;
      const float out = std::hypot(std::max(qx, 0.f), std::max(qy, 0.f)) +
                        std::min(std::max(qx, qy), 0.f) - radius;
      blend(x, y, colour, std::clamp(0.5f - out, 0.f, 1.f));
    }
}

void Canvas::posterise(int levels)
{
  std::uint8_t rounded[256];
  const int steps = levels - 1;
  for (int v = 0; v < 256; ++v)
    rounded[v] = static_cast<std::uint8_t>((2 * v * steps + 255) / 510 * 255 / steps);
  for (auto& byte : bytes_)
    byte = rounded[byte];
}

} // namespace pointmill::visual
