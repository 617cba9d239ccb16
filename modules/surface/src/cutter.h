// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

/// All that the search asks of a tool. One formula for one question, so that every way
/// to a point gives it the same bits.
class Cutter {
public:
  explicit Cutter(const Tool& tool)
      : profile_(tool.profile()), radius_(tool.radius()), radius2_(radius_ * radius_),
        ball_(tool.isBall())
  {
  }

  double radius() const { return radius_; }
  /// Squared radius: what is farther from the axis is not under the cutter.
  double radius2() const { return radius2_; }

  /// Height over the tip at this squared distance from the axis, up to radius2().
  double profile2(double distance2) const
  {
    return ball_ ? radius_ - std::sqrt(radius2_ - distance2)
                 : profile_.height(std::min(std::sqrt(distance2), radius_));
  }
  /// The same at a distance; beyond the rim, that of the rim.
  double profile(double distance) const
  {
    const double d = std::min(distance, radius_);
    return profile2(std::min(d * d, radius2_));
  }

  double penetration(const Eigen::Vector3d& a,
                     const Eigen::Vector3d& b,
                     const Eigen::Vector3d& p) const
  {
    return pointmill::penetration(profile_, a, b, p);
  }

private:
  CutterProfile profile_;
  double radius_, radius2_;
  bool ball_;
};

} // namespace pointmill
