// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>
#include <pointmill/surface/point_index.h>
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
/// The part is grown by the cutter and the allowance, so that nothing is gouged.
/// Without an index of its points the occupancy map is what is grown: every cell keeps
/// the tool away as if its highest point filled it. With one, heights are exact and the
/// cell does not decide the accuracy. Straight moves between neighbouring nodes
/// (diagonals too) are as safe as the nodes.
class LevelMap {
public:
  /// @param map organised occupancy map of the part; empty cells hold no part
  /// @param part the part's points and what bridges their gaps, or null
  /// @param allowance material to leave on the part, along its normal [mm]
  /// @param min_thickness stock less thick than this above what the tool would leave is
  ///        not worth cutting [mm]; 0: all of it is
  /// @param min_width nor is thicker stock that is a skin narrower than this [mm]
  LevelMap(const CellCloud& map,
           const PointIndex* part,
           const Tool& tool,
           double allowance,
           const StockField& stock,
           double min_thickness,
           double min_width,
           unsigned threads = 0);

  const CellGrid& grid() const { return grid_; }
  /// @brief Radius of the tool's end, within which a pass clears its level; the cone of
  /// a tapered tool only brushes what stands higher beside it.
  double endRadius() const { return end_radius_; }
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

  /// @brief A number for every node, the same where the tool, on whatever level, may
  /// cut the same stock: nodes that are needed on some level and less than a diameter
  /// apart. 0: far from all stock.
  std::vector<int> regions(double floor) const;

private:
  void dropOnCells(const CellCloud& map, const Tool& grown, double allowance);
  void dropOnPoints(const PointIndex& part, const Tool& tool, double allowance);
  void measureStock(const StockField& stock,
                    const Tool& tool,
                    double min_thickness,
                    double min_width);

  unsigned threads_;
  CellGrid grid_;
  double radius_, end_radius_;
  std::vector<float> lowest_, stock_top_;
};

} // namespace pointmill
