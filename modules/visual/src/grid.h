// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <Eigen/Geometry>

#include <string>

namespace pointmill::visual {

/// @brief An organised cloud of cells as a grid of heights.
class Grid {
public:
  /// @throws DataError naming @p what unless the cloud is organised, of at least 2 x 2
  /// cells, and its cells know where they are
  Grid(const CellCloud& cells, const std::string& what);

  const CellCloud& cells() const { return cells_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// @brief From one column or row to the next [mm]; may be negative.
  double stepX() const { return step_x_; }
  double stepY() const { return step_y_; }
  double x(int column) const { return first_x_ + column * step_x_; }
  double y(int row) const { return first_y_ + row * step_y_; }
  const PointCell& cell(int column, int row) const
  {
    return cells_[static_cast<std::size_t>(row) * columns_ + column];
  }
  /// @brief Height [mm], NaN where there is none or outside the grid.
  float z(int column, int row) const
  {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
      return std::numeric_limits<float>::quiet_NaN();
    return cell(column, row).z;
  }
  /// @brief Box of the cells that have a height; empty where none has.
  Eigen::AlignedBox3d box() const;

private:
  const CellCloud& cells_;
  int columns_;
  int rows_;
  double first_x_, first_y_, step_x_, step_y_;
};

} // namespace pointmill::visual
