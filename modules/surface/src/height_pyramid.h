// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/sorted_points.h>

#include <vector>

namespace pointmill {

/// How high the points of each cell reach, and of each square of 4 x 4 cells, of 16 x
/// 16 and so on. A square (a node) keeps its highest point and a slanted plane that no
/// point of it is above: on smooth ground a plane is tighter than a level lid by orders
/// of magnitude, and that is what makes the search short.
class HeightPyramid {
public:
  using Numbers = SortedPoints::Column;
  static constexpr int kSide = 4, kNodes = kSide * kSide; ///< of a block

  /// The nodes of one size, in blocks of 4 x 4 that are one node of the next size:
  /// node (i, j) is number `(j % 4) * 4 + i % 4` of block (i / 4, j / 4).
  struct Level {
    double size = 0; ///< edge of a node [mm]
    int blocks_x = 0, blocks_y = 0;
    Numbers top;              ///< highest point, -infinity for none
    Numbers mid;              ///< height of the plane over the node's middle
    Numbers slope_x, slope_y; ///< of the plane; cells have those of their parent

    std::size_t block(int bx, int by) const
    {
      return (static_cast<std::size_t>(by) * blocks_x + bx) * kNodes;
    }
    std::size_t node(int i, int j) const
    {
      return block(i / kSide, j / kSide) + j % kSide * kSide + i % kSide;
    }
  };

  explicit HeightPyramid(const CellFrame& frame);

  /// Fills cells and 4 x 4 squares of the rows [row0, row1); row0 is a multiple of 4.
  void addRows(const SortedPoints& points, int row0, int row1);
  /// The larger squares, after all rows.
  void finish();

  int levels() const { return static_cast<int>(levels_.size()); }
  const Level& level(int k) const { return levels_[k]; }

private:
  void addTile(const SortedPoints& points, int tx, int ty);
  void addParent(const Level& children, Level& parents, int i, int j);

  CellFrame frame_;
  std::vector<Level> levels_; // from the cells up to one block
};

} // namespace pointmill
