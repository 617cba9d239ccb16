// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace pointmill {

/// @brief A circle that a tool arrives on at a place in a direction, as a polygon.
struct TangentCircle {
  /// So many that the writer makes arcs of it: within 3 um of the circle at 5 mm.
  static constexpr int kSides = 96;

  Eigen::Vector3d end;
  Eigen::Vector2d centre;
  Eigen::Vector2d arm; ///< from the centre to the end
  int turn;            ///< 1: anticlockwise, -1: clockwise

  /// @param direction unit vector of the motion at @p end
  TangentCircle(const Eigen::Vector3d& place,
                const Eigen::Vector2d& direction,
                double radius,
                int turns)
      : end(place), turn(turns)
  {
    arm = radius * turn * Eigen::Vector2d(direction.y(), -direction.x());
    centre = end.head<2>() - arm;
  }

  /// @brief The corner that the tool passes @p i corners before the end, at its height.
  Eigen::Vector3d before(int i) const
  {
    if (i % kSides == 0)
      return end;
    const double angle = -turn * (i % kSides) * 2 * M_PI / kSides;
    const double c = std::cos(angle), s = std::sin(angle);
    return {centre.x() + c * arm.x() - s * arm.y(),
            centre.y() + s * arm.x() + c * arm.y(),
            end.z()};
  }
};

} // namespace pointmill
