// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pointmill {

/// A paraboloid of revolution: `height + bend r^2` at radius r.
struct Paraboloid {
  double height = 0, bend = 0;
};

/// Any cutter, as a polyline under its profile.
class SampledUnderside {
public:
  SampledUnderside() = default;
  /// @param profile convex and not decreasing over 0 .. @p radius
  SampledUnderside(double radius, const std::function<double(double)>& profile);

  /// A paraboloid that comes close to the cutter at radius @p r and is nowhere above
  /// it.
  Paraboloid touching(double r) const;

  /// About where the cutter is as steep as @p slope.
  double radiusAt(double slope) const;

private:
  static constexpr int kKnots = 32;
  double knot(int k) const { return std::min(radius_, radius_ * k / kKnots); }

  double radius_ = 0;
  std::array<double, kKnots + 1> profile_;      // at the knots
  std::array<double, 2 * kKnots> r_, corner_z_; // corners of the polyline
};

/// Paraboloids under a cutter, so that the search can bound what many points would do
/// to it without square roots.
class CutterUnderside {
public:
  explicit CutterUnderside(const Tool& tool);

  /// A paraboloid that comes close to the cutter at radius @p r and is nowhere above
  /// it.
  Paraboloid touching(double r) const
  {
    return rounded_ ? tangent(r) : sampled_.touching(r);
  }

  /// About where the cutter is as steep as @p slope.
  double radiusAt(double slope) const
  {
    return rounded_ ? flat_ + corner_ * slope / std::sqrt(1 + slope * slope)
                    : sampled_.radiusAt(slope);
  }

private:
  // In r^2 the profile is convex, so that its tangent at r is nowhere above it.
  Paraboloid tangent(double r) const
  {
    const double u = std::min(r - flat_, kSteepest * corner_);
    if (!(u > 0))
      return {0.0, bend_of_tip_};
    const double w = std::sqrt(corner_ * corner_ - u * u), at = flat_ + u;
    const double bend = 0.5 * u / (w * at);
    return {corner_ - w - bend * at * at, bend};
  }

  /// Cuts the rim off, where the cutter is as good as vertical.
  static constexpr double kSteepest = 0.98;

  double corner_, flat_, bend_of_tip_;
  bool rounded_; // a disc of radius flat_, rolled round by corner_, and nothing else
  SampledUnderside sampled_; // of other cutters
};

} // namespace pointmill
