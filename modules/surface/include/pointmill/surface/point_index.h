// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>
#include <pointmill/surface/contact.h>
#include <pointmill/surface/sorted_points.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace pointmill {

class HeightPyramid;

/// @brief The points of a part sorted into square XY cells, and the questions that
/// every tool path asks of them. All answers are exact with respect to the points:
/// every point under the cutter counts (paper 000, 3.3.2, corrected: `z_tip = max over
/// points of p.z - profile(|p - c|)`). Points are held as float32, all arithmetic that
/// shows is double. Answers depend neither on the order of the questions nor on the
/// processor; heights not on the order of the points either.
class PointIndex {
public:
  /// @param threads 0: as many as the machine has; the result is the same
  /// @throws DataError for no points at all, points that are not finite, or lists of
  ///         different lengths
  PointIndex(const std::vector<float>& x,
             const std::vector<float>& y,
             const std::vector<float>& z,
             unsigned threads = 0);

  /// @brief Of the finite points of all @p sources.
  /// @throws DataError for no finite point
  explicit PointIndex(std::vector<PointSource> sources, unsigned threads = 0);

  std::size_t size() const { return points_.size(); }
  Eigen::Vector3d point(std::size_t i) const
  {
    return {points_.x[i], points_.y[i], points_.z[i]};
  }
  const Eigen::Vector3d& min() const { return points_.min; }
  const Eigen::Vector3d& max() const { return points_.max; }

  /// @brief Drops @p tool at (x, y) until it rests on a point: of those that hold it at
  /// the same height, the first in the index. On nothing where a coordinate is NaN.
  Contact drop(const Tool& tool, double x, double y) const;

  /// @brief Drops @p tool at `count` places in a row, `from + i * step`; the same
  /// answers as drop(), sooner, where the places are near each other.
  void dropRow(const Tool& tool,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& step,
               std::size_t count,
               Contact* contacts) const;

  /// @brief The lowest height at which @p tool can move level from (ax, ay) to (bx, by)
  /// without entering a point; -infinity where it meets none.
  double dropAlong(const Tool& tool, double ax, double ay, double bx, double by) const;

  /// @brief The deepest that any point gets inside @p tool on the straight move from
  /// @p a to @p b, see penetration(); 0 where none gets deeper than @p tolerance.
  double gouge(const Tool& tool,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               double tolerance) const;

  /// @brief The points, in the order of the index.
  pcl::PointCloud<pcl::PointXYZ> toCloud() const;

  // The cells, for those who walk over all points.
  double cellSize() const { return points_.frame.cell; }
  int columns() const { return points_.frame.columns; }
  int rows() const { return points_.frame.rows; }
  /// @brief Points [first, last) of the cells @p column0 .. @p column1 of one row.
  std::pair<std::size_t, std::size_t> cells(int row, int column0, int column1) const
  {
    const std::size_t at = static_cast<std::size_t>(row) * columns();
    return {points_.start[at + column0], points_.start[at + column1 + 1]};
  }
  int columnOf(double x) const { return points_.frame.column(x); }
  int rowOf(double y) const { return points_.frame.row(y); }

private:
  void build(std::vector<PointSource> sources, unsigned threads, bool all_finite);

  SortedPoints points_;
  std::shared_ptr<const HeightPyramid> pyramid_; // of points_; it never changes
};

/// @brief Where the points of @p cloud lie that @p indices name, or all for nullptr.
/// Both must outlive the source.
template <typename PointT>
PointSource pointSource(const pcl::PointCloud<PointT>& cloud,
                        const pcl::Indices* indices = nullptr)
{
  const std::size_t count = indices ? indices->size() : cloud.size();
  if (count == 0)
    return {};
  const PointT& p = cloud.points.front();
  static_assert(sizeof(PointT) % sizeof(float) == 0, "no array of floats");
  return {{&p.x, &p.y, &p.z},
          sizeof(PointT) / sizeof(float),
          indices ? indices->data() : nullptr,
          count};
}

/// @brief An index of the finite points of @p cloud that @p indices name, and of the
/// finite points of @p fill (bridges over gaps, say).
template <typename PointT, typename FillT>
PointIndex makePointIndex(const pcl::PointCloud<PointT>& cloud,
                          const pcl::Indices& indices,
                          const pcl::PointCloud<FillT>& fill,
                          unsigned threads = 0)
{
  return PointIndex({pointSource(cloud, &indices), pointSource(fill)}, threads);
}

} // namespace pointmill
