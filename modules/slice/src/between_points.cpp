// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/gaps.h>

#include <Eigen/LU>

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

constexpr int kNeighbours = 8;

/// Height at (x, y) of the plane through some points, at most as high and as low as
/// they.
double planeHeight(const std::vector<Eigen::Vector3f>& points,
                   const pcl::Indices& which,
                   double x,
                   double y)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto i : which) {
    const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
    mean += p / static_cast<double>(which.size());
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (const auto i : which) {
    const Eigen::Vector3d d = points[static_cast<std::size_t>(i)].cast<double>() - mean;
    spread += d.head<2>() * d.head<2>().transpose();
    rise += d.head<2>() * d.z();
  }
  const double trace = spread.trace();
  if (!(spread.determinant() > 1e-4 * trace * trace)) // in a line: no plane
    return mean.z();
  const Eigen::Vector2d slope = spread.inverse() * rise;
  return std::clamp(
      mean.z() + slope.dot(Eigen::Vector2d(x, y) - mean.head<2>()), low, high);
}

} // namespace

void fillBetweenPoints(const CellGrid& grid,
                       const std::vector<unsigned char>& between,
                       const std::vector<Eigen::Vector3f>& points,
                       std::vector<double>& height)
{
  if (points.empty() || std::find(between.begin(), between.end(), 1) == between.end())
    return;
  pcl::PointCloud<pcl::PointXY>::Ptr flat(new pcl::PointCloud<pcl::PointXY>);
  flat->reserve(points.size());
  for (const auto& p : points)
    flat->push_back(pcl::PointXY{p.x(), p.y()});
  pcl::KdTreeFLANN<pcl::PointXY> tree;
  tree.setInputCloud(flat);
  pcl::Indices nearest;
  std::vector<float> squared;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t at = grid.index(column, row);
      if (!between[at])
        continue;
      const pcl::PointXY place{static_cast<float>(grid.x(column)),
                               static_cast<float>(grid.y(row))};
      tree.nearestKSearch(place, kNeighbours, nearest, squared);
      height[at] = planeHeight(points, nearest, place.x, place.y);
    }
}

} // namespace pointmill
