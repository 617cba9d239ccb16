// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Smallest value of the convex f on [lo, hi], by golden section.
template <typename F>
double minimumOf(double lo, double hi, F f)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double u = hi - golden * (hi - lo), v = lo + golden * (hi - lo);
  double fu = f(u), fv = f(v), best = std::min({f(lo), f(hi), fu, fv});
  for (int i = 0; i < 45; ++i) {
    if (fu < fv) {
      hi = v;
      v = u;
      fv = fu;
      u = hi - golden * (hi - lo);
      fu = f(u);
    }
    else {
      lo = u;
      u = v;
      fu = fv;
      v = lo + golden * (hi - lo);
      fv = f(v);
    }
    best = std::min({best, fu, fv});
  }
  return best;
}

/// Signed distance from a point to the tool's core, the solid that a ball of the corner
/// radius rolls round to give the cutter: a vertical cylinder of radius `flat` that
/// stands on `foot` and has no top. @p d is the horizontal distance to the axis.
double distanceToCore(double flat, double foot, double d, double z)
{
  const double side = d - flat, below = foot - z;
  if (side > 0 && below > 0)
    return std::hypot(side, below);
  return std::max(side, below);
}

} // namespace

double sweptHeight(const Tool& tool,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   double x,
                   double y)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), dz = b.z() - a.z();
  const double len2 = dx * dx + dy * dy, radius2 = tool.radius() * tool.radius();
  if (len2 < 1e-24) { // a vertical move: the lower end decides
    const double d2 = (x - a.x()) * (x - a.x()) + (y - a.y()) * (y - a.y());
    return d2 > radius2 ? kInfinity
                        : std::min(a.z(), b.z()) + tool.profile(std::sqrt(d2));
  }
  const double middle = ((x - a.x()) * dx + (y - a.y()) * dy) / len2;
  const double ex = a.x() + middle * dx - x, ey = a.y() + middle * dy - y;
  const double off2 = ex * ex + ey * ey; // to the line, squared
  if (off2 > radius2)
    return kInfinity;
  const double half = std::sqrt((radius2 - off2) / len2);
  const double first = std::max(0.0, middle - half),
               last = std::min(1.0, middle + half);
  if (first > last)
    return kInfinity;
  const auto height = [&](double t) {
    const double d2 = off2 + (t - middle) * (t - middle) * len2;
    return a.z() + t * dz + tool.profile(std::sqrt(std::min(d2, radius2)));
  };
  if (tool.isFlat())
    return a.z() + (dz < 0 ? last : first) * dz;
  if (dz == 0)
    return height(std::clamp(middle, first, last));
  if (tool.isBall()) {
    // The circle that the ball leaves at this distance, rolled down the slope.
    const double length = std::sqrt(len2), slope = dz / length;
    const double shift = std::sqrt((radius2 - off2)) * slope / std::hypot(1.0, slope);
    return height(std::clamp(middle - shift / length, first, last));
  }
  return minimumOf(first, last, height);
}

double penetration(const Tool& tool,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& p)
{
  const double corner = tool.corner_radius, flat = tool.radius() - corner;
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), dz = b.z() - a.z();
  const double len2 = dx * dx + dy * dy;
  const auto core = [&](double t) {
    const double d = std::hypot(a.x() + t * dx - p.x(), a.y() + t * dy - p.y());
    return distanceToCore(flat, a.z() + t * dz + corner, d, p.z());
  };
  if (len2 < 1e-24)
    return corner - core(dz < 0 ? 1.0 : 0.0);
  const double middle = ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / len2;
  const double nearest = std::clamp(middle, 0.0, 1.0);
  if (dz == 0)
    return corner - core(nearest);
  if (tool.isBall()) {
    // The core sweeps a vertical sheet: above the slanted line of ball centres.
    if (p.z() >= a.z() + nearest * dz + corner)
      return corner - core(nearest);
    const double squared = len2 + dz * dz;
    const double t =
        ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy + (p.z() - a.z() - corner) * dz) /
        squared;
    return corner - std::min(core(std::clamp(t, 0.0, 1.0)), core(nearest));
  }
  return corner - minimumOf(0.0, 1.0, core); // the distance to a convex solid is convex
}

} // namespace pointmill
