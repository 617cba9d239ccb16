// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/finish/chord_refiner.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector3d;

double ChordRefiner::lowest(double x, double y) const
{
  return std::max(floor_, surface_.drop(grown_, x, y).tip + allowance_);
}

// Every point near the chord is tried: a leap between two harmless ends does not hide.
bool ChordRefiner::cutsIn(const Vector3d& a, const Vector3d& b) const
{
  const Vector3d down(0, 0, allowance_);
  return surface_.points().gouge(grown_, a - down, b - down, tolerance_) > 0;
}

bool ChordRefiner::staysHigh(const Vector3d& a, const Vector3d& b) const
{
  const double length = (b - a).head<2>().norm();
  const double along_normal = length / std::hypot(length, b.z() - a.z());
  for (const double t : {0.5, 0.25, 0.75}) {
    const Vector3d p = a + t * (b - a);
    // The step error of paper 000, P_i.z - P_d.z, across the chord.
    if ((p.z() - lowest(p.x(), p.y())) * along_normal > tolerance_)
      return true;
  }
  return false;
}

void ChordRefiner::leap(const Vector3d& a,
                        const Vector3d& b,
                        std::vector<Vector3d>& path)
{
  const double clear =
      surface_.points().dropAlong(grown_, a.x(), a.y(), b.x(), b.y()) + allowance_;
  const double z = std::max({a.z(), b.z(), clear});
  if (z > a.z())
    path.emplace_back(a.x(), a.y(), z);
  path.emplace_back(b.x(), b.y(), z);
  if (z > b.z())
    path.push_back(b);
  ++leaps_;
}

void ChordRefiner::refine(const Vector3d& a,
                          const Vector3d& b,
                          std::vector<Vector3d>& path)
{
  const double length = (b - a).head<2>().norm();
  if (length <= 1e-9) { // straight up or down between two clear places
    path.push_back(b);
    return;
  }
  const bool cuts = cutsIn(a, b);
  if (!cuts && (length <= shortest_ || !staysHigh(a, b))) {
    path.push_back(b);
    return;
  }
  if (length <= shortest_) {
    leap(a, b, path);
    return;
  }
  Vector3d middle = 0.5 * (a + b);
  middle.z() = lowest(middle.x(), middle.y());
  refine(a, middle, path);
  refine(middle, b, path);
}

} // namespace pointmill
