// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "clouds.h"

#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pointmill;

namespace {

pcl::PCLPointCloud2 load(const std::string& path)
{
  readScan(path); // PCL's reader trusts any header, and prints
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  pcl::PCLPointCloud2 cloud;
  if (pcl::io::loadPCDFile(path, cloud) != 0)
    throw DataError(path + ": is no PCD file");
  return cloud;
}

std::string firstMissing(const pcl::PCLPointCloud2& cloud,
                         const std::vector<std::string>& fields)
{
  for (const auto& field : fields)
    if (std::none_of(cloud.fields.begin(), cloud.fields.end(), [&](const auto& f) {
          return f.name == field;
        }))
      return field;
  return {};
}

} // namespace

pcl::PointCloud<pcl::PointXYZ>::Ptr readPart(const std::string& path)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const RawScan raw = readScan(path);
  cloud->reserve(raw.points.size());
  for (const auto& p : raw.points) {
    const Eigen::Vector3f f = p.cast<float>();
    cloud->push_back({f.x(), f.y(), f.z()});
  }
  return cloud;
}

std::shared_ptr<const PointIndex> indexOf(const pcl::PointCloud<pcl::PointXYZ>& part)
{
  return std::make_shared<PointIndex>(std::vector<PointSource>{pointSource(part)});
}

bool hasFields(const std::string& path, const std::vector<std::string>& fields)
{
  const auto dot = path.find_last_of('.');
  return dot != std::string::npos && path.substr(dot) == ".pcd" &&
         firstMissing(load(path), fields).empty();
}

pcl::PCLPointCloud2 readFields(const std::string& path,
                               const std::vector<std::string>& fields,
                               const std::string& maker)
{
  auto cloud = load(path);
  const std::string missing = firstMissing(cloud, fields);
  if (!missing.empty())
    throw DataError(path + ": has no field '" + missing + "'; " + maker +
                    " writes such clouds");
  return cloud;
}

CellCloud withoutNan(const CellCloud& map)
{
  float lowest = std::numeric_limits<float>::infinity();
  for (const PointCell& cell : map)
    lowest = std::min(lowest, std::isfinite(cell.z) ? cell.z : lowest);
  CellCloud shown = map;
  for (PointCell& cell : shown)
    if (!std::isfinite(cell.z))
      cell.z = lowest;
  shown.is_dense = true;
  return shown;
}

CellCloud::Ptr readMap(const std::string& path)
{
  auto map = readPoints<PointCell>(path, "pm_occupancy");
  for (PointCell& cell : *map)
    if (cell.getState() == CellState::Empty)
      cell.z = std::numeric_limits<float>::quiet_NaN();
  map->is_dense = false;
  return map;
}
