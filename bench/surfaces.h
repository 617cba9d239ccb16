// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace bench {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double kEdge = 100;  ///< of each surface, from (0, 0) on [mm]
constexpr double kBall = 1.5;  ///< radius of the ball end mill [mm]
constexpr double kStepX = 0.1; ///< between the CL points of a row [mm]
constexpr double kStepY = 0.3; ///< between rows [mm]
constexpr int kColumns = 1000, kRows = 333;

inline double placeX(int column)
{
  return (column + 0.5) * kStepX;
}
inline double placeY(int row)
{
  return (row + 0.5) * kStepY;
}

/// @brief A surface with the height at which a ball end mill rests on it, all in mm.
struct Surface {
  const char* name;
  double (*height)(double x, double y);
  /// NaN where the contact is not on the surface.
  double (*tip)(double x, double y);
};

/// @brief `10 + 4 sin(x/9) cos(y/11) + 2 sin(x/4 + y/6)`. The resting height is the
/// maximum of `height(p) - profile(p)` under the ball, found by Newton's method to
/// 1e-9 mm; unique, since the surface is nowhere as hollow as the ball is round.
extern const Surface kFreeform;
/// @brief The upper half of a ball of radius 30 in the middle, on which the ball end
/// mill's centre moves on the sphere of radius 31.5.
extern const Surface kHemisphere;
/// @brief z = 5.
extern const Surface kLevel;

/// @brief `count` random points, the same in each run.
Cloud::Ptr makeCloud(const Surface& surface, std::size_t count);

/// @brief True resting heights at the CL points, row by row.
std::vector<double> truth(const Surface& surface);

} // namespace bench
