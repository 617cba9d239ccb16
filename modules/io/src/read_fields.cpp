// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>
#include <pointmill/io/read_fields.h>

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

namespace {

/// PCL's readers print what they do not like; what matters is thrown here.
class Quiet {
public:
  Quiet() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~Quiet() { pcl::console::setVerbosityLevel(before_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL before_ = pcl::console::getVerbosityLevel();
};

pcl::PointCloud<pcl::PointXYZ> placesOf(const RawScan& raw)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(raw.points.size());
  for (const auto& p : raw.points) {
    const Eigen::Vector3f f = p.cast<float>();
    cloud.push_back({f.x(), f.y(), f.z()});
  }
  return cloud;
}

/// Whether the finite points of @p read are those of @p truth, one by one.
bool agrees(const pcl::PCLPointCloud2& read,
            const pcl::PointCloud<pcl::PointXYZ>& truth)
{
  pcl::PointCloud<pcl::PointXYZ> places;
  pcl::fromPCLPointCloud2(read, places);
  auto at = truth.begin();
  for (const auto& p : places) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      continue;
    if (at == truth.end() || p.x != at->x || p.y != at->y || p.z != at->z)
      return false;
    ++at;
  }
  return at == truth.end();
}

} // namespace

pcl::PCLPointCloud2::Ptr readFields(const std::string& path,
                                    const std::vector<std::string>& needed)
{
  readScan(path); // PCL's reader trusts any header
  const Quiet quiet;
  pcl::PCLPointCloud2::Ptr cloud(new pcl::PCLPointCloud2);
  if (pcl::io::loadPCDFile(path, *cloud) != 0)
    throw DataError(path + ": is no PCD file");
  for (const auto& name : needed)
    if (std::none_of(cloud->fields.begin(), cloud->fields.end(), [&](const auto& f) {
          return f.name == name;
        }))
      throw DataError(path + ": has no field '" + name + "'");
  return cloud;
}

pcl::PCLPointCloud2::Ptr readScanFields(const std::string& path)
{
  const RawScan raw = readScan(path);
  const pcl::PointCloud<pcl::PointXYZ> places = placesOf(raw);
  const Quiet quiet;
  pcl::PCLPointCloud2::Ptr cloud(new pcl::PCLPointCloud2);
  const bool read = raw.format == "PCD"   ? pcl::io::loadPCDFile(path, *cloud) == 0
                    : raw.format == "PLY" ? pcl::io::loadPLYFile(path, *cloud) == 0
                                          : false;
  if (!read || !agrees(*cloud, places))
    pcl::toPCLPointCloud2(places, *cloud);
  return cloud;
}

} // namespace pointmill
