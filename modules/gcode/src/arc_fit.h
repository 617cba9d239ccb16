// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "arc_geometry.h"

#include <pointmill/gcode/machine_calls.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pointmill::gcode {

/// @brief What an arc must keep to; lengths in ticks.
struct ArcLimits {
  double tolerance = 0.0;
  double smallest_radius = 0.0, largest_radius = 0.0;
  double largest_sweep = 0.0; ///< rad, below a full turn
  double steepest = 0.0;      ///< tangent of a helix's largest lead angle
  double mismatch = 0.0;      ///< largest difference of both ends' radii
  double floor = -1e300;      ///< no arc dips below this Z
};

/// @brief Points in a row, at least two, and the chords between them; in ticks, whole
/// numbers.
struct Polyline {
  const Eigen::Vector3d* points = nullptr;
  std::size_t size = 0;

  const Eigen::Vector3d& operator[](std::size_t i) const { return points[i]; }
  const Eigen::Vector3d& front() const { return points[0]; }
  const Eigen::Vector3d& back() const { return points[size - 1]; }
};

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

inline MachinePosition toPosition(const Eigen::Vector3d& p)
{
  return {static_cast<std::int64_t>(p.x()),
          static_cast<std::int64_t>(p.y()),
          static_cast<std::int64_t>(p.z())};
}

/// @brief A call that stands for a polyline, and how far they are apart at most.
struct FittedArc {
  MachineArc arc;
  double deviation = 0.0;
};

/// @brief Bound of the Frechet distance between @p line and the straight move from its
/// first to its last point [ticks]; infinite where that is above @p tolerance or the
/// line runs backwards.
double straightDeviation(const Polyline& line, double tolerance);

/// @brief A bulge, the tangent of a quarter of the sweep, positive where it turns
/// counter-clockwise, of an arc from the first to the last point of @p line that passes
/// its other points and the middles of its chords within the tolerance, to first order.
/// None where there is none.
std::optional<double>
commonBulge(const Polyline& line, const PlaneAxes& axes, const ArcLimits& limits);

/// @brief Bound of the Frechet distance between @p line and the machine's way on @p arc
/// from its first to its last point [ticks]; infinite where that is above the
/// tolerance, the line runs backwards round the centre, or another limit is not kept.
double
arcDeviation(const Polyline& line, const MachineArc& arc, const ArcLimits& limits);

/// @brief An arc in @p plane that replaces @p line, proven by arcDeviation().
std::optional<FittedArc>
fitArc(const Polyline& line, ArcPlane plane, const ArcLimits& limits);

} // namespace pointmill::gcode
