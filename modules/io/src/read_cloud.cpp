// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"

#include <pointmill/io/read_cloud.h>

namespace pointmill {

pcl::PointCloud<pcl::PointXYZ> readCloud(const std::string& path)
{
  const detail::Source source(path);
  const RawScan raw = detail::readPcd(source);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(raw.points.size());
  for (const auto& p : raw.points) {
    if (!p.allFinite())
      source.fail("a point is not finite");
    const Eigen::Vector3f f = p.cast<float>();
    cloud.push_back({f.x(), f.y(), f.z()});
  }
  return cloud;
}

} // namespace pointmill
