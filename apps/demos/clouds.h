// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/io/read_fields.h>
#include <pointmill/slice/z_slices.h>
#include <pointmill/surface/point_index.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>
#include <vector>

/// @brief Refuses what is no scan or part by its fields, which would be milled all the
/// same.
/// @throws DataError for an occupancy map and for CL points; it says what takes them
void checkIsPart(const std::string& path);

/// @brief The points of a cloud or mesh in any supported format, where they are, in mm.
/// @throws DataError, see checkIsPart()
pcl::PointCloud<pcl::PointXYZ>::Ptr readPart(const std::string& path);

/// @brief The index of all of its points.
std::shared_ptr<const pointmill::PointIndex>
indexOf(const pcl::PointCloud<pcl::PointXYZ>& part);

/// @brief The levels of a part, from its top to its bottom.
/// @throws ParameterError where there are more points above them all together than a
/// cloud should hold
std::vector<double> levelsOf(const pcl::PointCloud<pcl::PointXYZ>& part,
                             pointmill::ZSlices slices);

/// @brief Whether it is an occupancy map, as pm_occupancy writes it.
bool isMap(const std::string& path);

/// @brief A map with no NaN, which pcl_viewer cannot show beside a place: its empty
/// cells lie at its lowest height.
pointmill::CellCloud withoutNan(const pointmill::CellCloud& map);

/// @brief A map as pm_occupancy writes it, with NaN in its empty cells again.
pointmill::CellCloud::Ptr readMap(const std::string& path);
