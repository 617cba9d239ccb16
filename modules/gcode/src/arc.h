// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace pointmill::gcode {

/// @brief An arc or helix about an axis: turning from axis @ref u to axis @ref v is
/// counter-clockwise, @ref w goes along. Where both radii differ the radius changes
/// evenly.
struct Arc {
  Eigen::Vector3d from, to;
  Eigen::Vector2d centre; ///< along u and v
  int u = 0, v = 1, w = 2;
  bool clockwise = false;

  double startRadius() const;
  double endRadius() const;
  /// @brief The angle travelled, above 0 and at most a full turn [rad].
  double sweep() const;
  /// @brief How many chords keep within @p error of the arc [mm].
  std::size_t chords(double error) const;
  /// @brief End of chord @p i of @p n, 1 .. n; the last one is @ref to itself.
  Eigen::Vector3d point(std::size_t i, std::size_t n) const;

private:
  Eigen::Vector2d arm(const Eigen::Vector3d& p) const
  {
    return Eigen::Vector2d(p[u], p[v]) - centre;
  }
};

} // namespace pointmill::gcode
