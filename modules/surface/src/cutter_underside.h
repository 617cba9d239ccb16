// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <algorithm>
#include <array>

namespace pointmill {

/// A paraboloid of revolution: `height + bend r^2` at radius r.
struct Paraboloid {
  double height = 0, bend = 0;
};

/// Simple surfaces that lie nowhere above a cutter's lower surface, so that the search
/// can bound what many points would do to the cutter without square roots.
class CutterUnderside {
public:
  explicit CutterUnderside(const Tool& tool);

  /// A paraboloid that comes close to the cutter at radius @p r and is nowhere above
  /// it.
  Paraboloid touching(double r) const;

private:
  double highestUnder(double bend) const;
  double knot(int k) const { return std::min(radius_, radius_ * k / kKnots); }

  /// Cuts the rim off, where the cutter is as good as vertical.
  static constexpr double kSteepest = 0.98;
  static constexpr int kKnots = 32;

  Tool tool_;
  double radius_, corner_, flat_;
  bool rounded_; // a disc of radius flat_, rolled round by corner_, and nothing else
  // Otherwise: corners of a polyline r, z with no part above the convex profile.
  int corners_ = 0;
  std::array<double, 2 * kKnots + 1> r_, z_;
};

} // namespace pointmill
