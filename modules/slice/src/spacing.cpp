// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/spacing.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pointmill {
namespace {

// Median distance from a uniform place in a unit square cell to its nearest corner.
constexpr double kMedianVoid = 0.3989;
constexpr std::size_t kPlaces = 4000;

double uniform(std::mt19937& random)
{
  return random() / 4294967296.0;
}

} // namespace

Spacing measureSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud, std::uint32_t seed)
{
  pcl::PointCloud<pcl::PointXY>::Ptr flat(new pcl::PointCloud<pcl::PointXY>);
  flat->reserve(cloud.size());
  for (const auto& p : cloud)
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      flat->push_back(pcl::PointXY{p.x, p.y});
  if (flat->empty())
    throw DataError("the spacing of no points was asked for");
  pcl::KdTreeFLANN<pcl::PointXY> tree;
  tree.setInputCloud(flat);

  // A place is taken near a random point, as far off as its neighbours reach, so that
  // sparse and dense parts both count and places outside the part stay few.
  std::mt19937 random(seed);
  std::vector<double> voids;
  pcl::Indices nearest;
  std::vector<float> squared;
  const int around = static_cast<int>(std::min<std::size_t>(9, flat->size()));
  for (std::size_t i = 0; i < kPlaces; ++i) {
    pcl::PointXY place = (*flat)[random() % flat->size()];
    tree.nearestKSearch(place, around, nearest, squared);
    const double reach = std::sqrt(squared.back());
    place.x += static_cast<float>((2 * uniform(random) - 1) * reach);
    place.y += static_cast<float>((2 * uniform(random) - 1) * reach);
    tree.nearestKSearch(place, 1, nearest, squared);
    voids.push_back(std::sqrt(squared.front()));
  }
  std::sort(voids.begin(), voids.end());
  return {voids[kPlaces / 2] / kMedianVoid, voids[kPlaces * 99 / 100] / kMedianVoid};
}

} // namespace pointmill
