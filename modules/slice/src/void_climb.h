// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "point_buckets.h"

#include <Eigen/Core>

#include <functional>

namespace pointmill {

/// @brief A disc in XY without points inside.
struct Void {
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< its middle [mm]
  double radius = 0;                            ///< distance to the nearest point [mm]
};

/// @brief The void at @p from grown until the points on its border hold it from all
/// sides: it moves towards the middle of the widest gap between them, where that is
/// half a circle or more, until it meets the next point. Exact, since each meeting is
/// the solution of a linear equation.
///
/// Stops before its middle goes where @p allowed (of a place) is false.
Void climbVoid(const PointBuckets& buckets,
               const Eigen::Vector2d& from,
               const std::function<bool(const Eigen::Vector2d&)>& allowed);

} // namespace pointmill
