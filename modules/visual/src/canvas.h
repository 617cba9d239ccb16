// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "colour.h"

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
  void line(float x0, float y0, float x1, float y1, float thickness, const Rgb& colour);

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

} // namespace pointmill::visual
