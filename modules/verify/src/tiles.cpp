// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "tiles.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

int cellsAlong(const PointIndex& points, double widest, double most)
{
  const double in_cell =
      static_cast<double>(points.size()) / points.columns() / points.rows();
  const double full = std::ceil(std::sqrt(most / in_cell));
  return static_cast<int>(std::clamp(
      std::ceil(widest / points.cellSize()), 1.0, std::clamp(full, 1.0, 1024.0)));
}

} // namespace

Tiles::Tiles(const PointIndex& points, double widest, double most)
    : points_(points), cells_(cellsAlong(points, widest, most)),
      columns_((points.columns() + cells_ - 1) / cells_),
      rows_((points.rows() + cells_ - 1) / cells_)
{
}

void Tiles::read(int column, int row, Tile& tile) const
{
  tile.points.clear();
  const int c0 = column * cells_, c1 = std::min(points_.columns(), c0 + cells_) - 1;
  const int r0 = row * cells_, r1 = std::min(points_.rows(), r0 + cells_) - 1;
  for (int r = r0; r <= r1; ++r) {
    const auto [first, last] = points_.cells(r, c0, c1);
    for (std::size_t i = first; i < last; ++i) {
      const Eigen::Vector3d p = points_.point(i);
      tile.points.push_back({p.x(), p.y(), p.z(), i});
    }
  }
  if (tile.points.empty())
    return;
  // The box of the points themselves: cells are often half empty.
  const auto& first = tile.points.front();
  double x0 = first.x, x1 = first.x, y0 = first.y, y1 = first.y;
  tile.top = first.z;
  for (const auto& p : tile.points) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    tile.top = std::max(tile.top, p.z);
  }
  tile.x = 0.5 * (x0 + x1);
  tile.y = 0.5 * (y0 + y1);
  tile.radius = 0.5 * std::hypot(x1 - x0, y1 - y0);
}

} // namespace pointmill
