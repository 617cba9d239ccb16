// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/machine_calls.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// @brief What a control makes of arcs, and the distance of paths, the slow and obvious
/// way. In ticks.
namespace arcs {

using Path = std::vector<Eigen::Vector3d>;

inline Eigen::Vector3d vector(const pointmill::MachinePosition& p)
{
  return {double(p.x), double(p.y), double(p.z)};
}

/// The plane's axes: first, second, and the one across it.
inline std::vector<int> axes(pointmill::ArcPlane plane)
{
  if (plane == pointmill::ArcPlane::XY)
    return {0, 1, 2};
  if (plane == pointmill::ArcPlane::ZX)
    return {2, 0, 1};
  return {1, 2, 0};
}

/// An arc as a control that has only its words understands it.
struct Turn {
  Eigen::Vector3d from, to;
  std::vector<int> axis;
  double u, v; ///< the centre
  double start_radius, end_radius;
  double start, sweep; ///< sweep negative where clockwise [rad]

  Turn(const Eigen::Vector3d& begin, const pointmill::MachineArc& arc)
      : from(begin), to(vector(arc.to)), axis(axes(arc.plane)),
        u(from[axis[0]] + double(arc.u)), v(from[axis[1]] + double(arc.v)),
        start_radius(std::hypot(from[axis[0]] - u, from[axis[1]] - v)),
        end_radius(std::hypot(to[axis[0]] - u, to[axis[1]] - v)),
        start(std::atan2(from[axis[1]] - v, from[axis[0]] - u)),
        sweep(std::atan2(to[axis[1]] - v, to[axis[0]] - u) - start)
  {
    const double turn = 2 * std::acos(-1.0);
    while (arc.clockwise && sweep >= 0)
      sweep -= turn;
    while (!arc.clockwise && sweep <= 0)
      sweep += turn;
    while (arc.clockwise && sweep < -turn)
      sweep += turn;
    while (!arc.clockwise && sweep > turn)
      sweep -= turn;
  }
  Eigen::Vector3d at(double part) const
  {
    const double radius = start_radius + part * (end_radius - start_radius);
    Eigen::Vector3d p;
    p[axis[0]] = u + radius * std::cos(start + part * sweep);
    p[axis[1]] = v + radius * std::sin(start + part * sweep);
    p[axis[2]] = from[axis[2]] + part * (to[axis[2]] - from[axis[2]]);
    return p;
  }
  double degrees() const { return sweep * 180 / std::acos(-1.0); }
};

/// Each of the lines of @p path in @p n pieces.
inline Path refined(const Path& path, int n)
{
  Path fine{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i)
    for (int k = 1; k <= n; ++k)
      fine.push_back(path[i - 1] + (path[i] - path[i - 1]) * (double(k) / n));
  return fine;
}

inline double distance(const Eigen::Vector3d& p, const Path& path)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d d = path[i] - path[i - 1];
    const double squared = d.squaredNorm();
    const double t =
        squared > 0 ? std::clamp((p - path[i - 1]).dot(d) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, (path[i - 1] + t * d - p).norm());
  }
  return least;
}

/// The larger of both one-sided distances of two paths, from samples on each.
inline double hausdorff(const Path& a, const Path& b)
{
  double most = 0;
  for (const auto& p : a)
    most = std::max(most, distance(p, b));
  for (const auto& p : b)
    most = std::max(most, distance(p, a));
  return most;
}

} // namespace arcs
