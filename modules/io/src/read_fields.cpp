// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "text.h"

#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>
#include <pointmill/io/read_fields.h>

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

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
    if (!p.allFinite())
      continue;
    const Eigen::Vector3f f = p.cast<float>();
    cloud.push_back({f.x(), f.y(), f.z()});
  }
  return cloud;
}

/// Whether both stand for one number: what is parsed as float and what is rounded to it
/// may differ in the last bits.
bool isSame(float a, float b)
{
  constexpr float ulps = 4 * std::numeric_limits<float>::epsilon();
  return std::abs(a - b) <=
         std::max(ulps * std::abs(a), std::numeric_limits<float>::min());
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
    if (at == truth.end() || !isSame(p.x, at->x) || !isSame(p.y, at->y) ||
        !isSame(p.z, at->z))
      return false;
    ++at;
  }
  return at == truth.end();
}

bool isPcd(const std::string& path)
{
  return detail::lower(std::filesystem::path(path).extension().string()) == ".pcd";
}

} // namespace

std::vector<std::string> fieldsOf(const std::string& path)
{
  std::vector<std::string> fields;
  std::ifstream in(isPcd(path) ? path : std::string());
  constexpr int most = 100; // lines of a header; a comment may be long
  std::string line, word;
  for (int i = 0; i < most && fields.empty() && std::getline(in, line); ++i) {
    std::istringstream words(line);
    if (!(words >> word) || (word != "FIELDS" && word != "COLUMNS"))
      continue;
    while (words >> word)
      fields.push_back(word);
  }
  return fields;
}

pcl::PCLPointCloud2::Ptr readFields(const std::string& path,
                                    const std::vector<pcl::PCLPointField>& needed,
                                    const std::string& maker)
{
  detail::checkPcd(detail::Source(path));
  const Quiet quiet;
  pcl::PCLPointCloud2::Ptr cloud(new pcl::PCLPointCloud2);
  if (pcl::io::loadPCDFile(path, *cloud) != 0)
    throw DataError(path + ": is no PCD file");
  const std::string who = maker.empty() ? "" : "; " + maker + " writes such clouds";
  for (const auto& field : needed) {
    const int index = pcl::getFieldIndex(*cloud, field.name);
    if (index < 0)
      throw DataError(path + ": has no field '" + field.name + "'" + who);
    if (cloud->fields[static_cast<std::size_t>(index)].datatype != field.datatype)
      throw DataError(path + ": its field '" + field.name + "' has another type" + who);
  }
  return cloud;
}

pcl::PCLPointCloud2::Ptr readScanFields(const std::string& path)
{
  const RawScan raw =
      isPcd(path) ? detail::readPcd(detail::Source(path)) : readScan(path);
  const pcl::PointCloud<pcl::PointXYZ> places = placesOf(raw);
  if (places.empty())
    throw DataError(path + ": has no finite point");
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
