// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/surface/point_index.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>

#include <memory>
#include <string>
#include <vector>

/// @brief The points of a cloud or mesh in any supported format, where they are, in mm.
/// @throws DataError
pcl::PointCloud<pcl::PointXYZ>::Ptr readPart(const std::string& path);

/// @brief The index of all of its points.
std::shared_ptr<const pointmill::PointIndex>
indexOf(const pcl::PointCloud<pcl::PointXYZ>& part);

/// @brief Whether a PCD file has all of @p fields.
bool hasFields(const std::string& path, const std::vector<std::string>& fields);

/// @brief Whether it is an occupancy map, as pm_occupancy writes it.
inline bool isMap(const std::string& path)
{
  return hasFields(path, {"label", "count"});
}

/// @brief A map with no NaN, which pcl_viewer cannot show beside a place: its empty
/// cells lie at its lowest height.
pointmill::CellCloud withoutNan(const pointmill::CellCloud& map);

/// @brief A map as pm_occupancy writes it, with NaN in its empty cells again.
pointmill::CellCloud::Ptr readMap(const std::string& path);

/// @brief A PCD file, all of whose points have @p fields; what PCL's reader would leave
/// undefined is refused.
/// @throws DataError, which says that @p maker writes such clouds
pcl::PCLPointCloud2 readFields(const std::string& path,
                               const std::vector<std::string>& fields,
                               const std::string& maker);

/// @brief A cloud of PointT from a PCD file.
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr readPoints(const std::string& path,
                                                 const std::string& maker)
{
  std::vector<std::string> fields;
  for (const auto& field : pcl::getFields<PointT>())
    fields.push_back(field.name);
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  pcl::fromPCLPointCloud2(readFields(path, fields, maker), *cloud);
  return cloud;
}
