// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief A PCD file with all its fields, whatever they are.
/// @throws DataError where it is none, or lacks one of @p needed
pcl::PCLPointCloud2::Ptr readFields(const std::string& path,
                                    const std::vector<std::string>& needed = {});

/// @brief A scan with what PCL's reader finds in its file beside x, y and z; for other
/// formats than PCD and PLY, and where that reader is wrong about the places, these
/// alone.
/// @throws DataError, see readScan()
pcl::PCLPointCloud2::Ptr readScanFields(const std::string& path);

/// @brief The cloud of PointT in a PCD file, as writeCloud() writes it.
/// @throws DataError where it lacks one of PointT's fields, which PCL's reader would
/// leave undefined
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr readPoints(const std::string& path)
{
  std::vector<std::string> needed;
  for (const auto& field : pcl::getFields<PointT>())
    if (field.name != "_") // what only fills up
      needed.push_back(field.name);
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  pcl::fromPCLPointCloud2(*readFields(path, needed), *cloud);
  return cloud;
}

} // namespace pointmill
