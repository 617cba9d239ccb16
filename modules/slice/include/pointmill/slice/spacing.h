// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pointmill {

/// @brief How far apart the points of a scan lie in XY.
struct Spacing {
  double median = 0; ///< edge of the square grid with the same median void [mm]
  double p99 = 0;    ///< the same for the void that 99 % of the places stay below [mm]
};

/// @brief Measures the distance from seeded random places among the points to the
/// nearest point in XY. On a square grid of edge s its median is 0.37 s, so that lines
/// that are dense along and sparse across count with their wide side too.
/// @throws DataError for a cloud without finite points
Spacing measureSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                       std::uint32_t seed = 1);

} // namespace pointmill
