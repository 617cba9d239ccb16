// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// The slow and obvious way, to judge the fast one by.
namespace brute {

using Points = std::vector<Eigen::Vector3d>;

inline double
drop(const Points& points, const pointmill::Tool& tool, double x, double y)
{
  double tip = -std::numeric_limits<double>::infinity();
  for (const auto& p : points)
    tip = std::max(tip, p.z() - tool.profile(std::hypot(p.x() - x, p.y() - y)));
  return tip;
}

/// Deepest that `p` gets inside the tool at tip `t`: by bisection on the tool shrunk by
/// e. Of a tapered tool right as far as the depth of its corner radius.
inline double
inside(const pointmill::Tool& tool, const Eigen::Vector3d& t, const Eigen::Vector3d& p)
{
  const auto in = [&](double e) {
    pointmill::Tool small = tool;
    small.diameter = std::max(0.0, tool.diameter - 2 * e);
    small.corner_radius = std::max(0.0, tool.corner_radius - e);
    small.tip_diameter = std::max(0.0, tool.tip_diameter - 2 * e);
    return t.z() + e + small.profile(std::hypot(p.x() - t.x(), p.y() - t.y())) < p.z();
  };
  if (!in(0))
    return 0;
  double lo = 0, hi = tool.radius();
  for (int i = 0; i < 60; ++i) {
    const double e = (lo + hi) / 2;
    (in(e) ? lo : hi) = e;
  }
  return lo;
}

/// By many steps along the move.
inline double gouge(const pointmill::Tool& tool,
                    const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    const Eigen::Vector3d& p,
                    int steps = 2000)
{
  double worst = 0;
  for (int i = 0; i <= steps; ++i)
    worst = std::max(worst, inside(tool, a + (b - a) * (double(i) / steps), p));
  return worst;
}

inline double swept(const pointmill::Tool& tool,
                    const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    double x,
                    double y,
                    int steps = 20000)
{
  double low = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector3d t = a + (b - a) * (double(i) / steps);
    low = std::min(low, t.z() + tool.profile(std::hypot(x - t.x(), y - t.y())));
  }
  return low;
}

} // namespace brute
