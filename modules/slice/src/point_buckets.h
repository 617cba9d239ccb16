// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pointmill {

/// @brief Box of points seen from above [mm].
struct PlanBox {
  explicit PlanBox(const std::vector<Eigen::Vector3f>& points);
  Eigen::Vector2d low, high;
};

/// @brief Points sorted into the square XY cells of a grid, and who is nearest to a
/// place. The answers do not depend on the grid, only the time they take.
class PointBuckets {
public:
  using Points = std::vector<Eigen::Vector3f>;

  /// @param points finite, not empty @param grid covers all of them
  PointBuckets(Points points, const CellGrid& grid);

  /// @brief A grid over the points with one or two of them in a cell that has any.
  static CellGrid naturalGrid(const Points& points);

  const CellGrid& grid() const { return grid_; }
  /// @brief The points in the order of their cells, in a cell in that of the input.
  const Points& points() const { return points_; }
  /// @brief Points in the cells [column0, column1] of a row; parts outside have none.
  std::size_t count(int row, int column0, int column1) const;

  /// @brief Distance in XY from a place to the nearest point [mm]; infinity where none
  /// is nearer than @p most.
  double distance(double x, double y, double most) const;

  struct Neighbour {
    float squared;        ///< distance in space [mm2]
    std::uint32_t number; ///< in points()
    bool operator<(const Neighbour& o) const
    {
      return squared < o.squared || (squared == o.squared && number < o.number);
    }
  };
  /// @brief The @p k points nearest to @p place in space, nearest first; all there are
  /// where these are fewer.
  void
  nearest(const Eigen::Vector3f& place, std::size_t k, std::vector<Neighbour>&) const;

  /// @brief Calls `visit(point)` for the points of a cell and of the eight about it.
  template <typename Visit>
  void visitBlock(int column, int row, Visit&& visit) const
  {
    for (int r = row - 1; r <= row + 1; ++r)
      run(r, column - 1, column + 1, [&](const Eigen::Vector3f& p, std::uint32_t) {
        visit(p);
      });
  }

  /// @brief Calls `visit(point, number)` for the points about a place, ring of cells by
  /// ring of cells, as long as `wants(reached)` holds before a ring; all points nearer
  /// than `reached` have been visited then.
  template <typename Wants, typename Visit>
  void walk(double x, double y, Wants&& wants, Visit&& visit) const;

private:
  int columnOf(const Eigen::Vector3f& p) const
  {
    const auto column = static_cast<int>((p.x() - grid_.x0) * per_mm_);
    return std::clamp(column, 0, grid_.columns - 1);
  }
  int rowOf(const Eigen::Vector3f& p) const
  {
    const auto row = static_cast<int>((p.y() - grid_.y0) * per_mm_);
    return std::clamp(row, 0, grid_.rows - 1);
  }
  template <typename Visit>
  void run(int row, int column0, int column1, Visit&& visit) const;

  CellGrid grid_;
  double per_mm_;
  Points points_;
  std::vector<std::uint32_t> start_;
};

template <typename Visit>
void PointBuckets::run(int row, int column0, int column1, Visit&& visit) const
{
  column0 = std::max(column0, 0);
  column1 = std::min(column1, grid_.columns - 1);
  if (row < 0 || row >= grid_.rows || column0 > column1)
    return;
  const std::uint32_t end = start_[grid_.index(column1, row) + 1];
  for (std::uint32_t i = start_[grid_.index(column0, row)]; i < end; ++i)
    visit(points_[i], i);
}

template <typename Wants, typename Visit>
void PointBuckets::walk(double x, double y, Wants&& wants, Visit&& visit) const
{
  // A place beside the grid looks from the nearest cell, that much less far.
  const double u = (x - grid_.x0) * per_mm_, v = (y - grid_.y0) * per_mm_;
  const int c = static_cast<int>(std::clamp(u, 0.0, grid_.columns - 1.0));
  const int r = static_cast<int>(std::clamp(v, 0.0, grid_.rows - 1.0));
  const double inner = std::min(std::min(u - c, c + 1 - u), std::min(v - r, r + 1 - v));
  const int last =
      std::max(std::max(c, grid_.columns - 1 - c), std::max(r, grid_.rows - 1 - r));
  for (int row = r - 1; row <= r + 1; ++row)
    run(row, c - 1, c + 1, visit);
  for (int ring = 2; ring <= last; ++ring) {
    if (!wants((ring - 1 + inner) * grid_.cell))
      return;
    run(r - ring, c - ring, c + ring, visit);
    for (int row = r - ring + 1; row < r + ring; ++row) {
      run(row, c - ring, c - ring, visit);
      run(row, c + ring, c + ring, visit);
    }
    run(r + ring, c - ring, c + ring, visit);
  }
}

} // namespace pointmill
