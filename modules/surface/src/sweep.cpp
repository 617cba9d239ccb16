// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/maximum.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

double sweptHeight(const CutterProfile& cutter,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   double x,
                   double y)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), dz = b.z() - a.z();
  const double len2 = dx * dx + dy * dy, radius2 = cutter.radius() * cutter.radius();
  if (len2 < 1e-24) { // a vertical move: the lower end decides
    const double d2 = (x - a.x()) * (x - a.x()) + (y - a.y()) * (y - a.y());
    return d2 > radius2 ? kInfinity
                        : std::min(a.z(), b.z()) + cutter.height(std::sqrt(d2));
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
  double t = std::clamp(middle, first, last); // of a level move
  if (dz != 0) {
    const double length = std::sqrt(len2), way = dz < 0 ? length : -length;
    const auto [lo, hi] = std::minmax({(first - middle) * way, (last - middle) * way});
    t = middle + cutter.ahead(std::sqrt(off2), std::abs(dz) / length, lo, hi) / way;
    t = std::clamp(t, first, last);
  }
  const double d2 = off2 + (t - middle) * (t - middle) * len2;
  return a.z() + t * dz + cutter.height(std::sqrt(std::min(d2, radius2)));
}

double penetration(const CutterProfile& cutter,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& p)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), dz = b.z() - a.z();
  const double len2 = dx * dx + dy * dy;
  const auto depth = [&](double t) {
    const double d = std::hypot(a.x() + t * dx - p.x(), a.y() + t * dy - p.y());
    return cutter.depth(d, p.z() - a.z() - t * dz);
  };
  if (len2 < 1e-24)
    return depth(dz < 0 ? 1.0 : 0.0);
  const double middle = ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / len2;
  const double nearest = std::clamp(middle, 0.0, 1.0);
  if (dz == 0)
    return depth(nearest);
  if (cutter.isBall()) {
    // The ball's core sweeps a vertical sheet: above the slanted line of its centres.
    const double centre = a.z() + cutter.radius();
    if (p.z() >= centre + nearest * dz)
      return depth(nearest);
    const double squared = len2 + dz * dz;
    const double t =
        ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy + (p.z() - centre) * dz) / squared;
    return std::max(depth(std::clamp(t, 0.0, 1.0)), depth(nearest));
  }
  // Nearly all points that are asked for are outside, which is known sooner.
  const double above = p.z() - sweptHeight(cutter, a, b, p.x(), p.y());
  if (above <= 0)
    return above;
  return maximumOf(0.0, 1.0, depth); // depth in a convex solid is concave
}

} // namespace pointmill
