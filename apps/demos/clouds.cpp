// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "clouds.h"

#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pointmill;

namespace {

constexpr std::size_t kMostPoints = 20'000'000; // 640 MB of PointXYZL

bool hasFields(const std::string& path, const std::vector<std::string>& names)
{
  const auto fields = fieldsOf(path);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(fields.begin(), fields.end(), name) != fields.end();
  });
}

} // namespace

void checkIsPart(const std::string& path)
{
  if (isMap(path))
    throw DataError(path + ": is an occupancy map, not a part; pm_rough takes it");
  if (hasFields(path, {"feed", "level", "motion"}))
    throw DataError(path + ": holds CL points, not a part; pm_buffer_points and "
                           "pm_gcode take them");
}

bool isMap(const std::string& path)
{
  return hasFields(path, {"label", "count"});
}

pcl::PointCloud<pcl::PointXYZ>::Ptr readPart(const std::string& path)
{
  checkIsPart(path);
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

std::vector<double> levelsOf(const pcl::PointCloud<pcl::PointXYZ>& part, ZSlices slices)
{
  std::vector<float> heights;
  heights.reserve(part.size());
  for (const auto& p : part)
    heights.push_back(p.z);
  std::sort(heights.begin(), heights.end());
  slices.setZLimits(heights.front(), heights.back());
  const std::vector<double> levels = slices.levels();
  std::size_t points = 0;
  for (const double z : levels)
    points += static_cast<std::size_t>(
        heights.end() - std::upper_bound(heights.begin(), heights.end(), z));
  if (points > kMostPoints)
    throw ParameterError("a pitch of " + std::to_string(slices.getPitch()) +
                         " mm gives " + std::to_string(levels.size()) +
                         " levels with " + std::to_string(points) +
                         " points above them, over " + std::to_string(kMostPoints) +
                         "; choose a larger --pitch, or one --level");
  return levels;
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
