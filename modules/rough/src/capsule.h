// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pointmill {

namespace capsule {

/// The first whole number from @p v on, 0 at least.
inline int firstFrom(double v)
{
  const int whole = v > 0 ? static_cast<int>(v) : 0;
  return whole + (whole < v);
}

/// The last whole number up to @p v, below @p count; -1: none.
inline int lastTo(double v, int count)
{
  return v < 0 ? -1 : v < count ? static_cast<int>(v) : count - 1;
}

/// Calls take() for the columns from `left` to `right`, in cells; false ends it.
template <typename Take>
bool takeRow(const CellGrid& grid, int row, double left, double right, Take&& take)
{
  const int first = firstFrom(left), last = lastTo(right, grid.columns);
  if (first > last)
    return true;
  if constexpr (std::is_same_v<decltype(take(row, first, last)), bool>)
    return take(row, first, last);
  take(row, first, last);
  return true;
}

/// In cells, cells' centres being whole numbers.
inline Eigen::Vector2d inCells(const CellGrid& grid, const Eigen::Vector2d& p)
{
  return {(p.x() - grid.x0) / grid.cell - 0.5, (p.y() - grid.y0) / grid.cell - 0.5};
}

} // namespace capsule

/// @brief Calls take(row, first, last) for the cells whose centres lie within @p radius
/// of @p centre: one stretch in each row at most. A take() that returns a bool ends it
/// with false.
template <typename Take>
void forDisc(const CellGrid& grid,
             const Eigen::Vector2d& centre,
             double radius,
             Take&& take)
{
  const Eigen::Vector2d p = capsule::inCells(grid, centre);
  const double r = radius / grid.cell;
  const int last = capsule::lastTo(p.y() + r, grid.rows);
  for (int row = capsule::firstFrom(p.y() - r); row <= last; ++row) {
    const double dy = row - p.y(), half = std::sqrt(std::max(0.0, r * r - dy * dy));
    if (!capsule::takeRow(grid, row, p.x() - half, p.x() + half, take))
      return;
  }
}

/// @brief The same for the cells whose centres lie within @p radius of the segment from
/// @p from to @p to.
template <typename Take>
void forCapsule(const CellGrid& grid,
                const Eigen::Vector2d& from,
                const Eigen::Vector2d& to,
                double radius,
                Take&& take)
{
  if (from == to)
    return forDisc(grid, from, radius, take);
  const Eigen::Vector2d a = capsule::inCells(grid, from),
                        b = capsule::inCells(grid, to);
  const double r = radius / grid.cell;
  const Eigen::Vector2d along = b - a;
  const Eigen::Vector2d side =
      Eigen::Vector2d(-along.y(), along.x()) * (r / along.norm());
  const double slope = along.y() != 0 ? along.x() / along.y() : 0;
  const int last = capsule::lastTo(std::max(a.y(), b.y()) + r, grid.rows);
  for (int row = capsule::firstFrom(std::min(a.y(), b.y()) - r); row <= last; ++row) {
    double left = 1e300, right = -1e300;
    const auto reach = [&](double x0, double x1) {
      left = std::min(left, x0);
      right = std::max(right, x1);
    };
    // The ends' discs, and the edges of the strip between them.
    for (const auto* end : {&a, &b}) {
      const double dy = row - end->y(), half2 = r * r - dy * dy;
      if (half2 >= 0) {
        const double half = std::sqrt(half2);
        reach(end->x() - half, end->x() + half);
      }
    }
    if (along.y() != 0)
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector2d edge = a + sign * side;
        const double up = row - edge.y();
        if (along.y() > 0 ? up >= 0 && up <= along.y() : up <= 0 && up >= along.y()) {
          const double x = edge.x() + up * slope;
          reach(x, x);
        }
      }
    if (left <= right && !capsule::takeRow(grid, row, left, right, take))
      return;
  }
}

} // namespace pointmill
