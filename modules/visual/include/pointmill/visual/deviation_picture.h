// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes a map of deviations as a PNG, seen from above (X right, Y up): each
/// point's intensity is the milled surface's signed distance from it [mm], blue where
/// material is left, red where too much is gone, pale within the tolerance, and grey
/// where it is NaN: no tool came there. Points that no tool can be asked for are light
/// grey, and only counted. Points that share a cell of the map show the one in reach
/// that is farthest off. Under it stand a histogram over the bar of the colours, with
/// the tolerance marked, and of the points in reach the share that keeps it and the
/// percentiles. The colours end at what 99 of 100 of them keep, but not before 4
/// tolerances nor after 10.
/// @param tolerance deviations up to this, to either side, are in order [mm]
/// @param in_reach of each point whether a tool can reach it; empty: all are
/// @throws ParameterError where @p tolerance is not in 1e-4 .. 10; DataError where no
/// point has a place, all lie on a line along an axis, @p in_reach is of another size,
/// or @p path cannot be written (nothing is left then)
void writeDeviation(const std::string& path,
                    const pcl::PointCloud<pcl::PointXYZI>& deviation,
                    double tolerance,
                    const std::vector<bool>& in_reach = {},
                    const std::string& title = "deviation from the part");

/// @brief Where the colours of that map end [mm].
double deviationRange(const pcl::PointCloud<pcl::PointXYZI>& deviation,
                      double tolerance);

} // namespace pointmill
