// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pointmill {

/// @brief Reads back the places of a cloud that writeCloud() wrote, bit by bit and in
/// its order. Scans are read by readScan().
/// @throws DataError where @p path is no PCD file or a point of it is not finite
pcl::PointCloud<pcl::PointXYZ> readCloud(const std::string& path);

} // namespace pointmill
