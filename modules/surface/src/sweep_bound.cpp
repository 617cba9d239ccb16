// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/sweep_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// More than what rounding takes from lengths and heights [mm].
constexpr double kRounding = 1e-9;

} // namespace

double sweptHeightBound(const CutterProfile& cutter,
                        const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b,
                        double x,
                        double y,
                        double radius)
{
  const double r = cutter.radius(), reach = r + radius + kRounding;
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), len2 = dx * dx + dy * dy;
  const double ex = x - a.x(), ey = y - a.y();
  double tip = std::min(a.z(), b.z()), nearest = 0;
  if (len2 >= 1e-24) {
    const double middle = (ex * dx + ey * dy) / len2;
    const double ox = ex - middle * dx, oy = ey - middle * dy;
    const double room = reach * reach - ox * ox - oy * oy;
    if (room < 0)
      return kInfinity;
    const double half = std::sqrt(room / len2), dz = b.z() - a.z();
    const double first = std::max(0.0, middle - half);
    const double last = std::min(1.0, middle + half);
    if (first > last)
      return kInfinity;
    tip = a.z() + (dz < 0 ? last : first) * dz;
    nearest = std::clamp(middle, 0.0, 1.0);
  }
  const double ox = ex - nearest * dx, oy = ey - nearest * dy;
  const double away = std::sqrt(ox * ox + oy * oy) - radius - kRounding;
  if (away > r)
    return kInfinity;
  return tip + cutter.height(std::max(0.0, away)) - kRounding;
}

} // namespace pointmill
