// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cutter_underside.h"

#include "cutter.h"

#include <limits>

namespace pointmill {
SampledUnderside::SampledUnderside(double radius,
                                   const std::function<double(double)>& profile)
    : radius_(radius)
{
  for (int k = 0; k <= kKnots; ++k)
    profile_[k] = profile(knot(k));
  // Between two knots a convex function lies above its chords before and behind, both
  // extended: above the line over the knot and the corner where these meet. Before the
  // first knot it is level; in the last interval the chord before goes on to the rim.
  for (int k = 0; k < kKnots; ++k) {
    const double here = profile_[k + 1] - profile_[k];
    const double before = k > 0 ? profile_[k] - profile_[k - 1] : 0.0;
    const double after = k + 1 < kKnots ? profile_[k + 2] - profile_[k + 1] : here;
    const double turns = after - before;
    const double share = k + 1 < kKnots && turns > 0
                             ? std::clamp((after - here) / turns, 0.0, 1.0)
                             : 1.0;
    r_[2 * k] = knot(k);
    corner_z_[2 * k] = profile_[k];
    r_[2 * k + 1] = knot(k) + share * radius_ / kKnots;
    corner_z_[2 * k + 1] = profile_[k] + before * share;
  }
}

Paraboloid SampledUnderside::touching(double r) const
{
  const int k = std::clamp(static_cast<int>(r / radius_ * kKnots), 0, kKnots - 1);
  const auto slope = [&](int to) {
    const double a = knot(k), b = knot(to);
    return (profile_[to] - profile_[k]) / (b * b - a * a);
  };
  Paraboloid under;
  under.bend = std::min(slope(k + 1), slope(kKnots));
  // Line minus paraboloid is concave: the corners of the polyline decide.
  under.height = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < r_.size(); ++i)
    under.height = std::min(under.height, corner_z_[i] - under.bend * r_[i] * r_[i]);
  return under;
}

double SampledUnderside::radiusAt(double slope) const
{
  int k = 0;
  while (k < kKnots && profile_[k + 1] - profile_[k] < slope * (knot(k + 1) - knot(k)))
    ++k;
  return knot(k);
}

CutterUnderside::CutterUnderside(const Tool& tool)
    : corner_(tool.corner_radius), flat_(tool.radius() - corner_),
      bend_of_tip_(flat_ <= 0 && corner_ > 0 ? 0.5 / corner_ : 0.0)
{
  const Cutter cutter(tool);
  // At the rim the root turns rounding by 1e-16 into 1e-8.
  const auto is = [&](double r, double height) {
    return std::abs(cutter.profile(r) - height) <= 1e-6 * cutter.radius();
  };
  rounded_ = is(std::max(0.0, flat_), 0.0) && is(cutter.radius(), corner_);
  if (!rounded_)
    sampled_ = {cutter.radius(), [&](double r) { return cutter.profile(r); }};
}

} // namespace pointmill
