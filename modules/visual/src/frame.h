// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace pointmill::visual {

/// @brief What is seen at a pixel; decides how it is coloured.
enum class Surface : std::uint8_t { None, Scan, Gap, Faint, Machined, RawStock };

/// @brief A projected corner of a triangle.
struct Vertex {
  Eigen::Vector3f at;     ///< px, px, depth [mm]; see Camera::project
  Eigen::Vector3f normal; ///< in view axes, need not be of unit length
};

/// @brief The depth buffer of a picture and what its pixels show. It is drawn kSuper
/// times as large as the picture and averaged, so that edges come out smooth.
struct Frame {
  static constexpr int kSuper = 3;

  Frame(int w, int h);

  /// @brief Draws a triangle; the normal is blended between its corners.
  void triangle(const Vertex& a, const Vertex& b, const Vertex& c, Surface surface);

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * width + x;
  }

  static constexpr float kNothing = -std::numeric_limits<float>::infinity();

  int width;
  int height;
  std::vector<float> depth; ///< mm, larger is nearer; kNothing where nothing is seen
  std::vector<Eigen::Vector3f> normal; ///< in view axes
  std::vector<Surface> surface;
};

/// @brief The colours of a frame.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels;

  /// @brief Averages the pixels into the canvas at (x, y).
  void copyTo(Canvas& canvas, int x, int y) const;
};

} // namespace pointmill::visual
