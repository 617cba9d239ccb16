// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/point_index.h>

#include <vector>

namespace pointmill {

/// @brief The points of a few neighbouring cells, near enough to be judged together.
struct Tile {
  struct Point {
    double x, y, z; ///< [mm]
    std::size_t index;
  };
  std::vector<Point> points;
  double x = 0, y = 0; ///< middle of the points
  double radius = 0;   ///< all points are so near to the middle in XY [mm]
  double top = 0;      ///< highest point [mm]
};

/// @brief Square tiles over the cells of an index: each point lies in one of them.
class Tiles {
public:
  /// @param widest edge of a tile [mm], less where the points are dense; a tile is one
  /// cell where these are wider
  /// @param most as many points are worth a tile of their own
  Tiles(const PointIndex& points, double widest, double most);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double edge() const { return cells_ * points_.cellSize(); }

  /// @brief Reads the points of a tile; it may have none.
  void read(int column, int row, Tile& tile) const;

private:
  const PointIndex& points_;
  int cells_; ///< along a tile's edge
  int columns_, rows_;
};

} // namespace pointmill
