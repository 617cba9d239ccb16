// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>
#include <pointmill/surface/contact.h>

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pointmill {

/// @brief The points of a part sorted into square XY cells, and the questions that
/// every tool path asks of them. All answers are exact with respect to the points:
/// every point under the cutter counts (paper 000, 3.3.2, corrected: `z_tip = max over
/// points of p.z - profile(|p - c|)`). Points are held as float32, all arithmetic is
/// double.
class PointIndex {
public:
  /// @throws DataError for no points at all, points that are not finite, or lists of
  ///         different lengths
  PointIndex(std::vector<float> x, std::vector<float> y, std::vector<float> z);

  std::size_t size() const { return z_.size(); }
  Eigen::Vector3d point(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  const Eigen::Vector3d& min() const { return min_; }
  const Eigen::Vector3d& max() const { return max_; }

  /// @brief Drops @p tool at (x, y) until it rests on a point.
  Contact drop(const Tool& tool, double x, double y) const;

  /// @brief Drops @p tool at `count` places in a row, `from + i * step`; the same
  /// answers as drop(), sooner.
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

  // The cells, for those who walk over all points.
  double cellSize() const { return cell_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// @brief Points [first, last) of the cells @p column0 .. @p column1 of one row.
  std::pair<std::size_t, std::size_t> cells(int row, int column0, int column1) const
  {
    const std::size_t at = static_cast<std::size_t>(row) * columns_;
    return {start_[at + column0], start_[at + column1 + 1]};
  }
  int columnOf(double x) const;
  int rowOf(double y) const;

private:
  template <typename Visit>
  void
  scan(double ax, double ay, double bx, double by, double radius, Visit&& visit) const;

  std::vector<float> x_, y_, z_;
  std::vector<std::uint32_t> start_;
  std::vector<float> top_; // highest point of each cell
  Eigen::Vector3d min_, max_;
  double cell_ = 1.0;
  int columns_ = 1, rows_ = 1;
};

/// @brief An index of the finite points of @p cloud that @p indices name, and of the
/// finite points of @p fill (bridges over gaps, say).
template <typename PointT, typename FillT>
PointIndex makePointIndex(const pcl::PointCloud<PointT>& cloud,
                          const pcl::Indices& indices,
                          const pcl::PointCloud<FillT>& fill)
{
  std::vector<float> x, y, z;
  const auto reserve = [&](std::vector<float>& v) {
    v.reserve(indices.size() + fill.size());
  };
  reserve(x), reserve(y), reserve(z);
  const auto add = [&](const auto& p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return;
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  };
  for (const auto i : indices)
    add(cloud[i]);
  for (const auto& p : fill)
    add(p);
  return PointIndex(std::move(x), std::move(y), std::move(z));
}

} // namespace pointmill
