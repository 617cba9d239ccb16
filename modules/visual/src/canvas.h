// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "colour.h"

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
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  int width_;
  int height_;
  std::vector<std::uint8_t> bytes_;
};

template <typename Colour>
void Canvas::line(
    float x0, float y0, float x1, float y1, float thickness, const Colour& colour)
{
  const float half = thickness * 0.5f, dx = x1 - x0, dy = y1 - y0;
  const float length2 = std::max(dx * dx + dy * dy, 1e-12f);
  const int left = static_cast<int>(std::floor(std::min(x0, x1) - half - 1));
  const int right = static_cast<int>(std::ceil(std::max(x0, x1) + half + 1));
  const int top = static_cast<int>(std::floor(std::min(y0, y1) - half - 1));
  const int bottom = static_cast<int>(std::ceil(std::max(y0, y1) + half + 1));
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
