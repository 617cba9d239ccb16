// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pointmill {

/// @brief Calls take(row, first, last) for the cells whose centres lie within @p radius
/// of the segment from @p a to @p b: one stretch in each row at most. A take() that
/// returns a bool ends it with false.
template <typename Take>
void forCapsule(const CellGrid& grid,
                const Eigen::Vector2d& a,
                const Eigen::Vector2d& b,
                double radius,
                Take&& take)
{
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  const Eigen::Vector2d side =
      Eigen::Vector2d(-along.y(), along.x()) * (length > 0 ? radius / length : 0.0);
  const auto up = [&](double v, double origin) {
    return static_cast<int>(std::ceil((v - origin) / grid.cell - 0.5));
  };
  const auto down = [&](double v, double origin) {
    return static_cast<int>(std::floor((v - origin) / grid.cell - 0.5));
  };
  const int first = std::max(0, up(std::min(a.y(), b.y()) - radius, grid.y0));
  const int last =
      std::min(grid.rows - 1, down(std::max(a.y(), b.y()) + radius, grid.y0));
  for (int row = first; row <= last; ++row) {
    const double y = grid.y(row);
    double left = 1e300, right = -1e300;
    const auto reach = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    // The ends' discs, and the edges of the strip between them.
    for (const auto* end : {&a, &b}) {
      const double dy = y - end->y(), half2 = radius * radius - dy * dy;
      if (half2 >= 0) {
        const double half = std::sqrt(half2);
        reach(end->x() - half);
        reach(end->x() + half);
      }
    }
    if (along.y() != 0)
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector2d edge = a + sign * side;
        const double t = (y - edge.y()) / along.y();
        if (t >= 0 && t <= 1)
          reach(edge.x() + t * along.x());
      }
    if (left > right)
      continue;
    const int from = std::max(0, up(left, grid.x0));
    const int to = std::min(grid.columns - 1, down(right, grid.x0));
    if (from > to)
      continue;
    if constexpr (std::is_same_v<decltype(take(row, from, to)), bool>) {
      if (!take(row, from, to))
        return;
    }
    else
      take(row, from, to);
  }
}

} // namespace pointmill
