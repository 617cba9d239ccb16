// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pointmill {
namespace align {

using Points = std::vector<Eigen::Vector3d>;

/// @brief The direction of a scan that becomes +Z, found from its points.
struct UpDirection {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< of length 1
  /// -1 .. 1: how clearly the points themselves tell this side from the other. Where it
  /// is within +-0.1 the hint or the convention has decided.
  double evidence = 0.0;
  double base_share = 0.0; ///< of the points in the base plane; 0 without one
};

/// @brief How a base plane is searched.
struct PlaneSearch {
  double distance = 0.1; ///< a point so near belongs to the plane [mm]
  int iterations = 1000; ///< at most, of the random sampling
  double share = 0.05;   ///< of the points: a smaller plane is no base
};

/// @brief The normal of the plane that holds most points.
///
/// Random sample consensus with a fixed seed over at most 20,000 points finds it; all
/// points within twice the distance refine it, each with Tukey's biweight, in double.
/// The normal points to the side that has more points off the plane (at least 0.5 % of
/// all, and by more than a tenth). Otherwise it follows @p hint, a vector towards the
/// sensor or along the points' normals, and without one (zero) its dominant component
/// is positive.
/// @param points near the origin [mm]
/// @param name of the stage, for messages
/// @throws DataError where the points are collinear or no plane holds its share
UpDirection baseNormal(const Points& points,
                       const PlaneSearch& search,
                       const Eigen::Vector3d& hint,
                       const std::string& name);

/// @brief The direction in which the points vary least.
///
/// Its sign makes the flat side the base: it points to the longer tail of the heights,
/// by the quantiles 2 % and 98 % about the median, because a relief stands out of its
/// ground. Undecided, it follows the rules of baseNormal().
/// @throws DataError where the points are collinear or no direction is the thinnest by
/// 1 %, as with a cube or a rod
UpDirection thinnestDirection(const Points& points,
                              const Eigen::Vector3d& hint,
                              const std::string& name);

} // namespace align
} // namespace pointmill
