// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>

namespace pointmill {

/// @brief A cutter that makes many moves: its outline, worked out once, and a quick
/// lower bound of it, by which most places are told that a move does nothing to.
class SweptCutter {
public:
  explicit SweptCutter(const CutterProfile& profile);
  explicit SweptCutter(const Tool& tool) : SweptCutter(tool.profile()) {}

  const CutterProfile& profile() const { return profile_; }
  double radius() const { return profile_.radius(); }

  /// @brief No more than the height of the cutter's lower surface [mm] at the squared
  /// radius @p r2; infinite beyond the cutter.
  double floor(double r2) const
  {
    const double step = r2 * steps_per_area_;
    return step < kSteps ? floor_[static_cast<std::size_t>(step)]
                         : std::numeric_limits<double>::infinity();
  }

  /// @brief No more than sweptHeight() from @p a to @p b over (x, y): as if the tip
  /// were everywhere as low as at the lower end, and anywhere in the move's box.
  double
  floor(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double x, double y) const
  {
    const double dx = outside(a.x(), b.x(), x), dy = outside(a.y(), b.y(), y);
    return std::min(a.z(), b.z()) + floor(dx * dx + dy * dy) - 1e-9;
  }

private:
  static double outside(double a, double b, double v)
  {
    return std::max({0.0, std::min(a, b) - v, v - std::max(a, b)});
  }
  static constexpr int kSteps = 1024; ///< of equal squares of the radius
  CutterProfile profile_;
  double steps_per_area_;
  std::array<double, kSteps> floor_;
};

} // namespace pointmill
