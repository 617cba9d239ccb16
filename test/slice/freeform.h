// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill_test/random.h>

#include <Eigen/Core>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

namespace pointmill_test {

/// A surface with slopes up to 45 degrees and radii of curvature down to 5 mm.
inline double freeform(double x, double y)
{
  return 10 + 4 * std::sin(x / 9) * std::cos(y / 11) + 2 * std::sin(x / 4 + y / 6);
}

inline Eigen::Vector3d freeformNormal(double x, double y)
{
  const double wave = 2 * std::cos(x / 4 + y / 6);
  return Eigen::Vector3d(-4 / 9.0 * std::cos(x / 9) * std::cos(y / 11) - wave / 4,
                         4 / 11.0 * std::sin(x / 9) * std::sin(y / 11) - wave / 6,
                         1)
      .normalized();
}

/// Random points of the freeform over a square, moved along its normal by Gaussian
/// noise.
inline pcl::PointCloud<pcl::PointXYZ>
freeformScan(double edge, double density, double noise, std::uint64_t seed = 1)
{
  Random random(seed);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const auto count = static_cast<std::size_t>(edge * edge * density);
  cloud.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge);
    const Eigen::Vector3d p = Eigen::Vector3d(x, y, freeform(x, y)) +
                              noise * random.normal() * freeformNormal(x, y);
    cloud.push_back({float(p.x()), float(p.y()), float(p.z())});
  }
  return cloud;
}

} // namespace pointmill_test
