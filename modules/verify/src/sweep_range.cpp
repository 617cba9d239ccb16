// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "sweep_range.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// More than what rounding takes from lengths and heights [mm].
constexpr double kRounding = 1e-9;

} // namespace

HeightRange sweptHeightRange(const CutterProfile& cutter,
                             const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b,
                             double x,
                             double y,
                             double radius)
{
  const double r = cutter.radius(), reach = r + radius + kRounding;
  if (x < std::min(a.x(), b.x()) - reach || x > std::max(a.x(), b.x()) + reach ||
      y < std::min(a.y(), b.y()) - reach || y > std::max(a.y(), b.y()) + reach)
    return {};
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), dz = b.z() - a.z();
  const double ex = x - a.x(), ey = y - a.y(), len2 = dx * dx + dy * dy;
  double lowest = dz < 0 ? 1 : 0, nearest = lowest; // of a plunge: its lower end
  if (len2 >= 1e-24) {
    const double middle = (ex * dx + ey * dy) / len2;
    const double ox = ex - middle * dx, oy = ey - middle * dy;
    const double room = reach * reach - ox * ox - oy * oy;
    if (room < 0)
      return {};
    const double half = std::sqrt(room / len2);
    const double first = std::max(0.0, middle - half);
    const double last = std::min(1.0, middle + half);
    if (first > last)
      return {};
    lowest = dz < 0 ? last : first;
    nearest = std::clamp(middle, 0.0, 1.0);
  }
  const double ox = ex - nearest * dx, oy = ey - nearest * dy;
  const double away = std::sqrt(ox * ox + oy * oy), some = radius + kRounding;
  if (away - some > r)
    return {};
  return {a.z() + lowest * dz + cutter.height(std::max(0.0, away - some)) - kRounding,
          a.z() + nearest * dz + cutter.height(away + some) + kRounding};
}

} // namespace pointmill
