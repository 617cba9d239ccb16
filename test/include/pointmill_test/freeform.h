// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill_test/random.h>

#include <Eigen/Core>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

namespace pointmill_test {

/// @brief `z = 10 + 4 sin(x/9) cos(y/11) + 2 sin(x/4 + y/6)`: smooth ground with slopes
/// up to 45 degrees [mm].
struct Freeform {
  static double height(double x, double y)
  {
    return 10 + 4 * std::sin(x / 9) * std::cos(y / 11) + 2 * std::sin(x / 4 + y / 6);
  }
  static Eigen::Vector2d gradient(double x, double y)
  {
    const double wave = std::cos(x / 4 + y / 6);
    return {4.0 / 9 * std::cos(x / 9) * std::cos(y / 11) + wave / 2,
            -4.0 / 11 * std::sin(x / 9) * std::sin(y / 11) + wave / 3};
  }

  /// @brief Height of a ball's tip that rests on it at (x, y), to 1e-9: where it
  /// touches, the ground's normal points to its centre.
  static double tip(double radius, double x, double y)
  {
    Eigen::Vector2d at(x, y);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector2d g = gradient(at.x(), at.y());
      const Eigen::Vector2d next =
          Eigen::Vector2d(x, y) + radius * g / std::sqrt(1 + g.squaredNorm());
      const double moved = (next - at).norm();
      at = next;
      if (moved < 1e-10)
        break;
    }
    const double d2 = (at - Eigen::Vector2d(x, y)).squaredNorm();
    return height(at.x(), at.y()) - radius + std::sqrt(radius * radius - d2);
  }

  /// @brief @p count random points of it over a square, with noise of standard
  /// deviation
  /// @p noise [mm] along Z.
  static pcl::PointCloud<pcl::PointXYZ>::Ptr
  sample(std::size_t count, double edge, double noise, std::uint64_t seed)
  {
    Random random(seed);
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    cloud->reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = random.uniform(0, edge), y = random.uniform(0, edge);
      const double z = height(x, y) + (noise > 0 ? noise * random.normal() : 0.0);
      cloud->push_back({float(x), float(y), float(z)});
    }
    return cloud;
  }
};

} // namespace pointmill_test
