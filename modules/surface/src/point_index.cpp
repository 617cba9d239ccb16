// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/point_index.h>

#include "cell_sort.h"
#include "search.h"

#include <pointmill/common/error.h>

namespace pointmill {

PointIndex::PointIndex(const std::vector<float>& x,
                       const std::vector<float>& y,
                       const std::vector<float>& z,
                       unsigned threads)
{
  if (x.size() != z.size() || y.size() != z.size())
    throw DataError("the points' x, y and z are not of one number");
  build({{{x.data(), y.data(), z.data()}, 1, nullptr, z.size()}}, threads, true);
}

PointIndex::PointIndex(std::vector<PointSource> sources, unsigned threads)
{
  build(std::move(sources), threads, false);
}

void PointIndex::build(std::vector<PointSource> sources,
                       unsigned threads,
                       bool all_finite)
{
  CellSort sort(std::move(sources), threads);
  if (all_finite && sort.dropped() > 0)
    throw DataError("a point of the index is not finite");
  const auto pyramid = std::make_shared<HeightPyramid>(sort.points().frame);
  points_ = sort.run(
      [&](int row0, int row1) { pyramid->addRows(sort.points(), row0, row1); });
  pyramid->finish();
  pyramid_ = pyramid;
}

Contact PointIndex::drop(const Tool& tool, double x, double y) const
{
  Contact contact;
  dropRow(tool, {x, y}, {0, 0}, 1, &contact);
  return contact;
}

void PointIndex::dropRow(const Tool& tool,
                         const Eigen::Vector2d& from,
                         const Eigen::Vector2d& step,
                         std::size_t count,
                         Contact* contacts) const
{
  searches().back().drop_row({points_, *pyramid_}, tool, from, step, count, contacts);
}

double PointIndex::dropAlong(
    const Tool& tool, double ax, double ay, double bx, double by) const
{
  return searches().back().drop_along({points_, *pyramid_}, tool, {ax, ay}, {bx, by});
}

double PointIndex::gouge(const Tool& tool,
                         const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b,
                         double tolerance) const
{
  return searches().back().gouge({points_, *pyramid_}, tool, a, b, tolerance);
}

pcl::PointCloud<pcl::PointXYZ> PointIndex::toCloud() const
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(size());
  for (std::size_t i = 0; i < size(); ++i)
    cloud.push_back({points_.x[i], points_.y[i], points_.z[i]});
  return cloud;
}

} // namespace pointmill
