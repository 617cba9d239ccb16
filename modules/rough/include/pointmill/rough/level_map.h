// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>
#include <pointmill/surface/stock_field.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief A place where the tool's axis may stand: column and row of a LevelMap.
struct Node {
  int column = 0, row = 0;
  bool operator==(const Node& o) const { return column == o.column && row == o.row; }
  bool operator!=(const Node& o) const { return !(*this == o); }
  Node operator+(const Node& o) const { return {column + o.column, row + o.row}; }
};

/// @brief Everything that roughing needs to know of a part, a tool and a stock: on a
/// grid of nodes that reaches beyond the stock, how low the tool may go and how high
/// the stock stands that it would cut there. Made once, it answers every level.
///
/// The part is the occupancy map grown by the cutter's radius and the allowance: every
/// cell keeps the tool away as if its highest point filled it, so that no point of it
/// can be gouged, and straight moves between neighbouring nodes (diagonals too) are as
/// safe as the nodes.
class LevelMap {
public:
  /// @param map organised occupancy map of the part; empty cells hold no part
  /// @param allowance material to leave on the part, along its normal [mm]
  /// @param min_thickness stock less thick than this above what the tool would leave is
  ///        not worth cutting [mm]; 0: all of it is
  /// @param min_width nor is thicker stock that is a skin narrower than this [mm]
  LevelMap(const CellCloud& map,
           const Tool& tool,
           double allowance,
           const StockField& stock,
           double min_thickness,
           double min_width,
           unsigned threads = 0);

  const CellGrid& grid() const { return grid_; }
  double radius() const { return radius_; }
  bool has(Node n) const { return grid_.has(n.column, n.row); }
  double x(Node n) const { return grid_.x(n.column); }
  double y(Node n) const { return grid_.y(n.row); }

  /// @brief The lowest tip height that leaves the allowance; -infinity beside the part.
  double lowest(Node n) const { return lowest_[grid_.index(n.column, n.row)]; }
  /// @brief Whether the tool may stand at @p n with its tip on @p z.
  bool isFree(Node n, double z) const { return has(n) && lowest(n) <= z + 1e-6; }
  /// @brief Whether there is stock to cut under the tool at @p n with its tip on @p z.
  bool isNeeded(Node n, double z) const
  {
    return isFree(n, z) && stock_top_[grid_.index(n.column, n.row)] > z + 1e-3;
  }

private:
  CellGrid grid_;
  double radius_;
  std::vector<float> lowest_, stock_top_;
};

} // namespace pointmill
