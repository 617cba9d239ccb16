// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cutter_underside.h"

#include <algorithm>
#include <limits>

namespace pointmill {

CutterUnderside::CutterUnderside(const Tool& tool)
    : tool_(tool), radius_(tool.radius()), corner_(tool.corner_radius),
      flat_(radius_ - corner_),
      bend_of_tip_(flat_ <= 0 && corner_ > 0 ? 0.5 / corner_ : 0.0),
      rounded_(tool.profile(std::max(0.0, flat_)) == 0.0 &&
               std::abs(tool.profile(radius_) - corner_) <= 1e-9 * radius_)
{
  if (rounded_)
    return;
  // Between two knots a convex function lies above its chords before and behind, both
  // extended; before the first it is level, behind the last there is none.
  const auto add = [&](double r, double z) {
    r_[corners_] = r;
    z_[corners_++] = z;
  };
  const double step = radius_ / kKnots;
  std::array<double, kKnots + 1> z;
  for (int k = 0; k <= kKnots; ++k)
    z[k] = tool.profile(knot(k));
  for (int k = 0; k < kKnots; ++k) {
    const double before = k > 0 ? z[k] - z[k - 1] : 0.0, here = z[k + 1] - z[k];
    const double after = k + 1 < kKnots ? z[k + 2] - z[k + 1] : 0.0;
    const double turns = after - before;
    // In the last interval the chord before goes on to the rim.
    const bool to_rim = k + 1 == kKnots || !(turns > 0);
    const double share = to_rim ? 1.0 : std::clamp((after - here) / turns, 0.0, 1.0);
    add(knot(k), z[k]);
    add(knot(k) + share * step, z[k] + before * share);
  }
}

double CutterUnderside::highestUnder(double bend) const
{
  // Line minus paraboloid is concave: the corners of the polyline decide.
  double height = std::numeric_limits<double>::infinity();
  for (int i = 0; i < corners_; ++i)
    height = std::min(height, z_[i] - bend * r_[i] * r_[i]);
  return height;
}

Paraboloid CutterUnderside::chord(double r) const
{
  const int k = std::clamp(static_cast<int>(r / radius_ * kKnots), 0, kKnots - 1);
  const auto slope = [&](double a, double b) {
    return (tool_.profile(b) - tool_.profile(a)) / (b * b - a * a);
  };
  const double bend = std::min(slope(knot(k), knot(k + 1)), slope(knot(k), radius_));
  return {highestUnder(bend), bend};
}

} // namespace pointmill
