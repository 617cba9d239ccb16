// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/strays.h>
#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>
#include <pointmill/common/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pointmill {
namespace {

/// The points sorted into square cells in XY.
class Grid {
public:
  struct Point {
    float x, y, z;
    std::uint32_t index; ///< in the cloud
  };

  Grid(const pcl::PointCloud<pcl::PointXYZ>& cloud, double cell)
  {
    Eigen::Vector2d high;
    low_ = high = cloud.front().getVector3fMap().head<2>().cast<double>();
    for (const auto& p : cloud) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw DataError("a point whose company was asked for is not finite");
      low_ = low_.cwiseMin(Eigen::Vector2d(p.x, p.y));
      high = high.cwiseMax(Eigen::Vector2d(p.x, p.y));
    }
    // Far strays must not make more cells than there are points.
    const Eigen::Vector2d size = high - low_;
    const auto most = static_cast<double>(cloud.size());
    cell_ =
        std::max({cell, std::sqrt(size.x() * size.y() / most), size.maxCoeff() / most});
    columns_ = static_cast<int>(size.x() / cell_) + 1;
    rows_ = static_cast<int>(size.y() / cell_) + 1;

    std::vector<std::uint32_t> cells(cloud.size());
    start_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      cells[i] = static_cast<std::uint32_t>(rowOf(cloud[i].y)) * columns_ +
                 static_cast<std::uint32_t>(columnOf(cloud[i].x));
      ++start_[cells[i] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
      start_[c] += start_[c - 1];
    points_.resize(cloud.size());
    auto next = start_;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      points_[next[cells[i]]++] = {
          cloud[i].x, cloud[i].y, cloud[i].z, static_cast<std::uint32_t>(i)};
  }

  int rows() const { return rows_; }
  int columnOf(double x) const { return clamped((x - low_.x()) / cell_, columns_); }
  int rowOf(double y) const { return clamped((y - low_.y()) / cell_, rows_); }

  struct Range {
    const Point *first, *last;
    const Point* begin() const { return first; }
    const Point* end() const { return last; }
  };
  /// The points of the cells column0 .. column1 of a row.
  Range cells(int row, int column0, int column1) const
  {
    const std::size_t at = static_cast<std::size_t>(row) * columns_;
    return {points_.data() + start_[at + column0],
            points_.data() + start_[at + column1 + 1]};
  }
  Range row(int r) const { return cells(r, 0, columns_ - 1); }

private:
  static int clamped(double v, int count)
  {
    return static_cast<int>(std::clamp(v, 0.0, count - 1.0));
  }

  Eigen::Vector2d low_;
  double cell_;
  int columns_, rows_;
  std::vector<std::uint32_t> start_;
  std::vector<Point> points_;
};

/// Whether `needed` points, p among them, are within the radius.
bool inCompany(const Grid& grid, const Grid::Point& p, double radius, int needed)
{
  const double squared = radius * radius;
  const auto count = [&](const Grid::Range& range) {
    for (const auto& q : range) {
      const float dx = p.x - q.x, dy = p.y - q.y, dz = p.z - q.z;
      if (dx * dx + dy * dy + dz * dz <= squared && --needed <= 0)
        return true;
    }
    return false;
  };
  const int row = grid.rowOf(p.y), column = grid.columnOf(p.x);
  if (count(grid.cells(row, column, column)))
    return true;
  const double reach = radius * (1 + 1e-6); // float32 may round a distance down
  const int c0 = grid.columnOf(p.x - reach), c1 = grid.columnOf(p.x + reach);
  const int r0 = grid.rowOf(p.y - reach), r1 = grid.rowOf(p.y + reach);
  for (int r = r0; r <= r1; ++r) {
    if (r != row) {
      if (count(grid.cells(r, c0, c1)))
        return true;
    }
    else if ((c0 < column && count(grid.cells(r, c0, column - 1))) ||
             (column < c1 && count(grid.cells(r, column + 1, c1))))
      return true;
  }
  return false;
}

} // namespace

pcl::Indices pointsInCompany(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                             double radius,
                             int company,
                             unsigned threads)
{
  checkRange("strays", "radius", radius, "mm", {1e-9, 1e9});
  checkRange("strays", "company", company, "points", {0, 1e6});
  if (cloud.empty())
    return {};
  const Grid grid(cloud, radius / 2);
  std::vector<unsigned char> keep(cloud.size());
  parallelFor(static_cast<std::size_t>(grid.rows()), threads, [&](std::size_t row) {
    for (const auto& p : grid.row(static_cast<int>(row)))
      keep[p.index] = inCompany(grid, p, radius, company + 1);
  });
  pcl::Indices kept;
  kept.reserve(cloud.size());
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i])
      kept.push_back(static_cast<pcl::index_t>(i));
  return kept;
}

} // namespace pointmill
