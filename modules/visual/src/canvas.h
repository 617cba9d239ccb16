// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/visual/colour.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pointmill::visual {

/// @brief A rectangle of pixels, y down.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

/// @brief An RGB picture in memory, row by row from the top; drawing outside of it is
/// ignored.
class Canvas {
public:
  Canvas(int width, int height, const Rgb& background);

  int width() const { return width_; }
  int height() const { return height_; }
  /// @brief From now on what is drawn outside of @p rect is ignored.
  void clip(const Rect& rect);
  /// @brief Draws anywhere again.
  void unclip() { clip({0, 0, width_, height_}); }
  const std::uint8_t* row(int y) const { return &bytes_[offset(0, y)]; }

  void set(int x, int y, const Rgb& colour);
  /// @brief Covers @p alpha (0 .. 1) of a pixel.
  void blend(int x, int y, const Rgb& colour, float alpha);
  void fill(const Rect& rect, const Rgb& colour);
  /// @brief Rectangle with corners of @p radius [px] and smooth edges.
  void fillRound(const Rect& rect, float radius, const Rgb& colour);
  /// @brief Smooth straight line, @p thickness in px.
  void line(float x0, float y0, float x1, float y1, float thickness, const Rgb& colour)
  {
    line(x0, y0, x1, y1, thickness, [&](float) { return colour; });
  }
  /// @brief The same with a colour for each place, `colour(t)` with t from 0 at its
  /// beginning to 1.
  template <typename Colour>
  void
  line(float x0, float y0, float x1, float y1, float thickness, const Colour& colour);

  /// @brief Rounds every channel to one of @p levels values, 0 and 255 among them: a
  /// picture with smooth edges becomes a much smaller file.
  void posterise(int levels);

private:
  std::size_t offset(int x, int y) const
  {
    return 3 * (static_cast<std::size_t>(y) * width_ + x);
  }
  bool inside(int x, int y) const
  {
    return x >= clip_.x && y >= clip_.y && x < clip_.right() && y < clip_.bottom();
  }
  int width_;
  int height_;
  Rect clip_;
  std::vector<std::uint8_t> bytes_;
};

template <typename Colour>
void Canvas::line(
    float x0, float y0, float x1, float y1, float thickness, const Colour& colour)
{
  const float half = thickness * 0.5f, dx = x1 - x0, dy = y1 - y0;
  const float length2 = std::max(dx * dx + dy * dy, 1e-12f);
  const auto first = [&](float a, float b, int from) {
    return static_cast<int>(
        std::max(std::floor(std::min(a, b) - half - 1), static_cast<float>(from)));
  };
  const auto last = [&](float a, float b, int to) {
    return static_cast<int>(
        std::min(std::ceil(std::max(a, b) + half + 1), static_cast<float>(to - 1)));
  };
  const int left = first(x0, x1, clip_.x), right = last(x0, x1, clip_.right());
  const int top = first(y0, y1, clip_.y), bottom = last(y0, y1, clip_.bottom());
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const float px = x + 0.5f - x0, py = y + 0.5f - y0;
      const float t = std::clamp((px * dx + py * dy) / length2, 0.f, 1.f);
      const float away = std::hypot(px - t * dx, py - t * dy);
      if (away < half + 0.5f)
        blend(x, y, colour(t), std::min(half + 0.5f - away, 1.f));
    }
}

} // namespace pointmill::visual
