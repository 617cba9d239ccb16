// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <Eigen/Geometry>

namespace pointmill::visual {

/// @brief The part frame seen from above, X right and Y up, on a rectangle of a canvas.
struct Plan {
  Rect place;
  double scale = 1;             ///< px per mm
  Eigen::Vector2d corner{0, 0}; ///< upper left corner of the place [mm]

  Eigen::Vector2f px(const Eigen::Vector2d& mm) const
  {
    return {static_cast<float>(place.x + (mm.x() - corner.x()) * scale),
            static_cast<float>(place.y + (corner.y() - mm.y()) * scale)};
  }
  /// @brief The middle of a pixel [mm].
  Eigen::Vector2d mm(int x, int y) const
  {
    return {corner.x() + (x + 0.5 - place.x) / scale,
            corner.y() - (y + 0.5 - place.y) / scale};
  }
  float px(double length) const { return static_cast<float>(length * scale); }
};

} // namespace pointmill::visual
