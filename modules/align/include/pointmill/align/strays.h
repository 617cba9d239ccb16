// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

namespace pointmill {

/// @brief The points, in order, that have at least @p company others within @p radius
/// [mm]: all but dust, reflections and mixed pixels.
///
/// The same points as `pcl::RadiusOutlierRemoval` keeps, from a grid instead of a tree:
/// most points find their company in their own cell.
/// @param threads 0: as many as the machine has
/// @throws ParameterError unless radius > 0 and company >= 0, DataError for points that
/// are not finite
pcl::Indices pointsInCompany(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                             double radius,
                             int company,
                             unsigned threads = 0);

} // namespace pointmill
