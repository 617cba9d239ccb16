// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>

namespace pointmill {

/// @brief Where a cutter comes to rest on a surface.
struct Contact {
  double tip = -std::numeric_limits<double>::infinity(); ///< height of the tip [mm]
  std::int64_t point = -1; ///< position in the index of the point there, or -1
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< the contact point itself [mm]

  bool touches() const { return point >= 0; }
};

/// @brief Unit normal of @p tool's surface, pointing to the tool's inside, where it
/// rests on @p contact with its axis at (x, y): the surface's own normal, where that is
/// smooth. Up where it rests on nothing.
Eigen::Vector3d
contactNormal(const Tool& tool, double x, double y, const Contact& contact);

} // namespace pointmill
