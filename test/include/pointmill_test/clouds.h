// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/surface/point_index.h>
#include <pointmill_test/random.h>

#include <brute_force.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>

namespace pointmill_test {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// @brief A rectangle in XY [mm].
struct Rectangle {
  double x0, y0, x1, y1;

  /// Distance from (x, y) to the rectangle, 0 inside.
  double distance(double x, double y) const
  {
    return std::hypot(std::max({x0 - x, 0.0, x - x1}), std::max({y0 - y, 0.0, y - y1}));
  }
  bool holds(double x, double y) const { return distance(x, y) == 0; }
  /// Less by @p margin on each side.
  Rectangle inner(double margin) const
  {
    return {x0 + margin, y0 + margin, x1 - margin, y1 - margin};
  }
};

/// @brief Adds points on z = height(x, y) over the rectangle, borders included, @p step
/// apart at most. Places where the height is NaN get none.
template <typename Height>
void addSurface(Cloud& cloud, const Rectangle& area, double step, Height height)
{
  const int nx = static_cast<int>(std::ceil((area.x1 - area.x0) / step - 1e-9));
  const int ny = static_cast<int>(std::ceil((area.y1 - area.y0) / step - 1e-9));
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = area.x0 + (area.x1 - area.x0) * i / std::max(1, nx);
      const double y = area.y0 + (area.y1 - area.y0) * j / std::max(1, ny);
      const double z = height(x, y);
      if (std::isfinite(z))
        cloud.push_back(pcl::PointXYZ(float(x), float(y), float(z)));
    }
}

template <typename Height>
Cloud::Ptr surface(const Rectangle& area, double step, Height height)
{
  Cloud::Ptr cloud(new Cloud);
  addSurface(*cloud, area, step, height);
  return cloud;
}

/// @brief Level bumps of random size and height, 0 .. @p high, at random places.
class Bumps {
public:
  Bumps(const Rectangle& area, double high, int count, std::uint64_t seed)
  {
    Random random(seed);
    for (int i = 0; i < count; ++i)
      bumps_.push_back({random.uniform(area.x0, area.x1),
                        random.uniform(area.y0, area.y1),
                        random.uniform(1.0, 5.0),
                        random.uniform(0.2, 1.0) * high});
  }
  double operator()(double x, double y) const
  {
    double z = 0.3 * std::sin(0.5 * x) * std::cos(0.4 * y);
    for (const auto& b : bumps_) {
      const double d = std::hypot(x - b.x, y - b.y);
      if (d < b.radius)
        z = std::max(z, b.height * (1 - 0.3 * d / b.radius)); // walls and slopes
    }
    return z;
  }

private:
  struct Bump {
    double x, y, radius, height;
  };
  std::vector<Bump> bumps_;
};

inline brute::Points pointsOf(const Cloud& cloud)
{
  brute::Points points;
  for (const auto& p : cloud)
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      points.emplace_back(p.x, p.y, p.z);
  return points;
}

inline std::shared_ptr<pointmill::PointIndex> indexOf(const Cloud& cloud)
{
  pcl::Indices all(cloud.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<pcl::index_t>(i);
  return std::make_shared<pointmill::PointIndex>(
      pointmill::makePointIndex(cloud, all, Cloud()));
}

inline Eigen::Vector3d position(const pointmill::PointCL& p)
{
  return {p.x, p.y, p.z};
}

/// @brief Calls move(from, to, point) for the moves within the passes of @p path; a
/// pass of one point is a move on the spot.
template <typename Move>
void forMovesOfPasses(const pointmill::CLCloud& path, Move&& move)
{
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool inside = i > 0 && path[i - 1].label == path[i].label;
    move(position(path[inside ? i - 1 : i]), position(path[i]), path[i]);
  }
}

/// @brief All that a CL cloud says, as bytes.
inline std::string bytes(const pointmill::CLCloud& path)
{
  std::string all;
  const auto add = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    all.append(raw, sizeof value);
  };
  for (const auto& p : path) {
    add(p.x), add(p.y), add(p.z);
    add(p.normal_x), add(p.normal_y), add(p.normal_z);
    add(p.feed), add(p.label), add(p.level), add(p.motion);
  }
  return all;
}

} // namespace pointmill_test
