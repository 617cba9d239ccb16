// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/machine_calls.h>

#include <Eigen/Core>

#include <cstdint>

namespace pointmill::gcode {

/// @brief Axes 0 .. 2: turning from u to v is counter-clockwise, w goes along.
struct PlaneAxes {
  int u, v, w;

  Eigen::Vector2d project(const Eigen::Vector3d& p) const { return {p[u], p[v]}; }
};

inline PlaneAxes axesOf(ArcPlane plane)
{
  return plane == ArcPlane::XY   ? PlaneAxes{0, 1, 2}
         : plane == ArcPlane::ZX ? PlaneAxes{2, 0, 1}
                                 : PlaneAxes{1, 2, 0};
}

inline std::int64_t along(const MachinePosition& p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

inline std::int64_t& along(MachinePosition& p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// @brief An arc that starts at @p from, about its centre. Ticks.
class ArcGeometry {
public:
  ArcGeometry(const MachinePosition& from, const MachineArc& arc);

  double radius() const; ///< at the start
  /// @brief Counter-clockwise positive, in (0, 2 pi] or its negative: a full turn where
  /// start and end are the same in the plane [rad].
  double sweep() const { return sweep_; }
  /// @brief The point after @p part of the sweep, 0 .. 1, on the nearest ticks; along
  /// the axis on the one above, so that nothing is cut deeper.
  MachinePosition point(double part) const;
  /// @brief The arc to @p to from @p from, both of which point() gave, round the same
  /// centre.
  MachineArc piece(const MachinePosition& from, const MachinePosition& to) const;

private:
  MachinePosition from_;
  MachineArc arc_;
  PlaneAxes axis_;
  std::int64_t centre_u_, centre_v_;
  double start_angle_, end_radius_, sweep_;
};

} // namespace pointmill::gcode
