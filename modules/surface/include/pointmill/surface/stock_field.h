// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/surface/swept_cutter.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace pointmill {

/// @brief What a move takes from the stock.
struct Cut {
  /// A thinner layer is swarf, or what rounding left: it has no area [mm].
  static constexpr double kSwarf = 0.05;

  double depth = 0;  ///< thickest layer [mm]
  double volume = 0; ///< [mm3]
  /// Ground that the cutter begins to cut, so that what it cuts in several moves counts
  /// once, if it loses more than kSwarf should the move go on level for a diameter
  /// [mm2]. Divided by the way in XY it is the width of the cut, by nominal heights.
  double area = 0;
  /// Thickest layer, on that ground with what it loses then [mm].
  double axial = 0;
};

/// @brief A cell that a move has lowered by so much [mm].
struct LoweredCell {
  int column, row;
  double depth;
};

/// @brief What still stands of the stock, as a height over each cell of a regular grid
/// [mm]. Tools come from above only, so one height says it all.
class StockField {
public:
  enum class Bound {
    Upper,  ///< never lower than what stands anywhere in the cell: for planning moves
    Nominal ///< exact at the cell's centre: for simulation
  };

  /// @throws ParameterError unless the box has volume, 0.01 <= cell [mm], and there are
  /// less than 100 million cells
  StockField(const Stock& stock, double cell, Bound bound);

  /// @brief Lowers every cell to @p height of its centre [mm], where that is lower.
  void lowerTo(const std::function<double(double x, double y)>& height);

  /// @brief Moves @p tool straight from @p a to @p b through the cells of rows
  /// [@p row0, @p row1), so that threads can share the work by rows.
  /// @param lowered takes, if given, the lowered cells as well, by rows and columns
  /// @return what it took, by the cells' centres; nothing in the air
  Cut cut(const Tool& tool,
          const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          int row0,
          int row1,
          std::vector<LoweredCell>* lowered = nullptr);
  Cut cut(const Tool& tool, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  {
    return cut(tool, a, b, 0, rows_);
  }

  /// @brief The same without area and axial depth, for those who make many moves with
  /// one cutter.
  Cut cut(const SweptCutter& cutter,
          const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          int row0,
          int row1,
          std::vector<LoweredCell>* lowered = nullptr);

  /// @brief How deep [mm] @p cutter would get into the stock on a straight move from
  /// @p a to @p b, in the cells of rows [@p row0, @p row1), by their centres. Nothing
  /// is cut.
  double depthAlong(const SweptCutter& cutter,
                    const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    int row0,
                    int row1) const;
  /// @brief The highest of the cells of rows [@p row0, @p row1).
  double highestIn(int row0, int row1) const;

  /// @brief Depth and volume that straight moves from each place of @p way to the next
  /// would take, by the cells' centres; the stock stays as it is.
  Cut probe(const Tool& tool, const std::vector<Eigen::Vector3d>& way) const;
  /// @brief How deep [mm] @p tool, its tip anywhere in the box @p low .. @p high, gets
  /// into the stock in the cells of rows [@p row0, @p row1), by their centres. Nothing
  /// is cut.
  double depthIn(const Tool& tool,
                 const Eigen::Vector3d& low,
                 const Eigen::Vector3d& high,
                 int row0,
                 int row1) const;

  /// @brief The highest stock within @p radius of the segment from (ax, ay) to (bx,
  /// by), -infinity where there is none.
  double highest(double ax, double ay, double bx, double by, double radius) const;
  double highest(double x, double y, double radius) const
  {
    return highest(x, y, x, y, radius);
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cellSize() const { return cell_; }
  double x(int column) const { return stock_.min.x() + (column + 0.5) * cell_; }
  double y(int row) const { return stock_.min.y() + (row + 0.5) * cell_; }
  int rowOf(double y) const;
  double height(int column, int row) const
  {
    return height_[static_cast<std::size_t>(row) * columns_ + column];
  }
  const Stock& stock() const { return stock_; }

  /// @brief The field as an organised cloud; z is the height.
  CellCloud toCloud() const;

private:
  /// Columns and rows whose cells' centres a tool may pass over.
  struct Window {
    int c0, c1, r0, r1;
  };
  template <typename Box, typename Floor, typename Body>
  void forRuns(const Window& window,
               const Box& box,
               double lowest,
               const Floor& floor,
               const Body& body) const;
  void updateTop(int row, int run);
  Window under(double radius, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  Stock stock_;
  double cell_;
  Bound bound_;
  int columns_, rows_, runs_;
  std::vector<float> height_;
  std::vector<float> top_; // highest of each run of cells of a row
};

} // namespace pointmill
