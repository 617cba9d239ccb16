// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "clouds.h"

#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pointmill;

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
  const auto cloud = readScanFields(path);
  return std::all_of(fields.begin(), fields.end(), [&](const std::string& name) {
    return pcl::getFieldIndex(*cloud, name) >= 0;
  });
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
