// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill_test/random.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pointmill_test {

/// @name Surfaces in closed form, heights z(x, y) >= 0 in mm
/// @{
inline double plane(double x, double y)
{
  return 5 + 0.1 * x + 0.05 * y;
}

/// A cap of a sphere of radius 25, 15 high, on the ground.
inline double dome(double x, double y)
{
  const double r2 = (x - 30) * (x - 30) + (y - 30) * (y - 30);
  return r2 < 525 ? std::sqrt(625 - r2) - 10 : 0;
}

/// 45 degrees, 20 high, on the ground.
inline double cone(double x, double y)
{
  return std::max(0.0, 20 - std::sqrt((x - 30) * (x - 30) + (y - 30) * (y - 30)));
}

/// Four treads of 15 mm, each 4 mm above the last.
inline double stairs(double x, double)
{
  return 4 * std::clamp(std::floor(x / 15), 0.0, 3.0);
}

/// A half-round groove of radius 8 along X in a block 10 high.
inline double channel(double, double y)
{
  return 10 - std::sqrt(std::max(0.0, 64 - (y - 20) * (y - 20)));
}

/// A hyperbolic paraboloid, 8 at its middle.
inline double saddle(double x, double y)
{
  return 8 + ((x - 30) * (x - 30) - (y - 20) * (y - 20)) / 80;
}
/// @}

/// @brief One of the surfaces above over 0 <= x <= length, 0 <= y <= width.
struct Shape {
  const char* name;
  double length;
  double width;
  double (*z)(double x, double y);
};

inline const std::vector<Shape>& shapes()
{
  static const std::vector<Shape> all = {{"plane", 60, 40, plane},
                                         {"dome", 60, 60, dome},
                                         {"cone", 60, 60, cone},
                                         {"stairs", 60, 40, stairs},
                                         {"channel", 60, 40, channel},
                                         {"saddle", 60, 40, saddle}};
  return all;
}

/// @brief Points of @p shape, one in each cell of a grid of @p step [mm], at a random
/// place in it (jitter 1) or in its middle (jitter 0). x and y are rounded before z is
/// computed, so that each point is as exact as a float. Gaussian @p noise [mm] moves z.
inline pcl::PointCloud<pcl::PointXYZ>::Ptr sample(const Shape& shape,
                                                  double step,
                                                  std::uint64_t seed,
                                                  double noise = 0.0,
                                                  double jitter = 1.0)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  Random random(seed);
  const int columns = static_cast<int>(std::lround(shape.length / step));
  const int rows = static_cast<int>(std::lround(shape.width / step));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double u = 0.5 + jitter * (random.uniform() - 0.5);
      const double v = 0.5 + jitter * (random.uniform() - 0.5);
      const auto x = static_cast<float>((column + u) * shape.length / columns);
      const auto y = static_cast<float>((row + v) * shape.width / rows);
      double z = shape.z(x, y);
      if (noise > 0)
        z += noise * random.normal();
      cloud->push_back(pcl::PointXYZ(x, y, static_cast<float>(z)));
    }
  return cloud;
}

} // namespace pointmill_test
