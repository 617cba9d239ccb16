// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief The names of a PCD file's fields, by its header alone; none for other files.
std::vector<std::string> fieldsOf(const std::string& path);

/// @brief A PCD file with all its fields, whatever they are, and however few points.
/// @param maker what writes such clouds, for the message
/// @throws DataError where it is none, or lacks one of @p needed, by name and type,
/// which PCL's conversion would leave out
pcl::PCLPointCloud2::Ptr readFields(const std::string& path,
                                    const std::vector<pcl::PCLPointField>& needed = {},
                                    const std::string& maker = "");

/// @brief A scan with what PCL's reader finds in its file beside x, y and z; for other
/// formats than PCD and PLY, and where that reader is wrong about the places, these
/// alone. A PCD file may have fewer points than a scan needs.
/// @throws DataError, see readScan()
pcl::PCLPointCloud2::Ptr readScanFields(const std::string& path);

/// @brief The cloud of PointT in a PCD file, as writeCloud() writes it.
/// @throws DataError, see readFields()
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr readPoints(const std::string& path,
                                                 const std::string& maker = "")
{
  std::vector<pcl::PCLPointField> needed;
  for (const auto& field : pcl::getFields<PointT>())
    if (field.name != "_") // what only fills up
      needed.push_back(field);
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  pcl::fromPCLPointCloud2(*readFields(path, needed, maker), *cloud);
  return cloud;
}

} // namespace pointmill
