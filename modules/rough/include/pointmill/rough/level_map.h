// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
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

/// @brief What a roughing operation is to clear, with what.
struct Clearing {
  Tool tool;
  /// Material to leave on the part, along its normal [mm].
  double allowance = 0.0;
  /// Stock less thick than this above what the tool would leave is not worth cutting
  /// [mm]; 0: all of it is.
  double min_thickness = 0.0;
  /// Nor is thicker stock that is a skin narrower than this [mm].
  double min_width = 0.0;
  /// Where no tool may be.
  KeepOut keep_out;
};

/// @brief Everything that roughing needs to know of a part, a tool and a stock: on a
/// grid of nodes that reaches beyond the stock, how low the tool may go and how high
/// the stock stands that it would cut there. Made once, it answers every level.
///
/// The part is grown by the cutter and the allowance, so that nothing is gouged.
/// Without an index of its points the occupancy map is what is grown: every cell keeps
/// the tool away as if its highest point filled it. With one, heights are exact and the
/// cell does not decide the accuracy.
///
/// Between nodes the tool is as safe as on them: the part is grown by as much more as
/// a point can be nearer to a place between nodes than to the nearest of them. With
/// nodes at distance R or more from a point, a place in their square is, by the
/// variance of the corners, at least sqrt(R^2 - cell^2 / 2) away.
class LevelMap {
public:
  /// @param map organised occupancy map of the part; empty cells hold no part
  /// @param part the part's points and what bridges their gaps, or null; it must
  /// outlive
  ///        the map
  LevelMap(const CellCloud& map,
           const PointIndex* part,
           const StockField& stock,
           const Clearing& clearing,
           unsigned threads = 0);

  const CellGrid& grid() const { return grid_; }
  const Tool& tool() const { return tool_; }
  /// @brief The block that the stock is in.
  const Stock& stock() const { return stock_; }
  /// @brief Radius of the tool's end, within which a pass clears its level; the cone of
  /// a tapered tool only brushes what stands higher beside it.
  double endRadius() const { return tool_.endDiameter() / 2; }
  bool has(Node n) const { return grid_.has(n.column, n.row); }
  std::size_t index(Node n) const { return grid_.index(n.column, n.row); }
  double x(Node n) const { return grid_.x(n.column); }
  double y(Node n) const { return grid_.y(n.row); }
  Eigen::Vector2d at(Node n) const { return {x(n), y(n)}; }

  /// @brief The lowest tip height that leaves the allowance; -infinity beside the part.
  double lowest(Node n) const { return lowest_[index(n)]; }
  /// @brief The lowest height at which the tool is proven to move level and straight
  /// from @p a to @p b; infinite beyond the nodes.
  double lowestAlong(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// @brief The same of the points themselves, for moves beside walls: lower, and
  /// slower. Without points it is the same.
  double lowestAlongPoints(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// @brief As lowest(), for a place between the nodes. Places no further apart than a
  /// diagonal of a cell, where the tool may stand, have a safe straight move between.
  double lowestAt(const Eigen::Vector2d& p) const;

  /// @brief Highest stock that is worth cutting under the tool's end [mm].
  double stockTop(Node n) const { return stock_top_[index(n)]; }
  /// @brief Highest stock in the node's own cell [mm], worth cutting or not.
  double standing(Node n) const { return standing_[index(n)]; }

  /// @brief How low the stock can be milled over each node's cell, whatever stands
  /// there now: the lowest that the tool's lower surface gets [mm].
  /// @param zones whether the zones that are kept out of count
  /// @param sure only what is under the tool with all of its cell
  std::vector<float> reach(bool zones, bool sure) const;

  /// @brief A number for every node, the same where the tool, on whatever level, may
  /// cut the same stock: nodes that are needed on some level and less than a diameter
  /// apart. 0: far from all stock.
  std::vector<int> regions(double floor) const;

private:
  void extend(const CellGrid& cells, const Stock& box, double room);
  void dropOnCells(const CellCloud& map, double allowance);
  void dropOnPoints();
  void keepOut();
  void measureStock(const StockField& stock, const Clearing& clearing);

  unsigned threads_;
  CellGrid grid_;
  Tool tool_;
  Stock stock_;
  const PointIndex* part_;
  KeepOut keep_out_;
  double allowance_, wider_; // wider_: see above
  std::vector<float> lowest_, without_zones_, stock_top_, standing_;
};

} // namespace pointmill
