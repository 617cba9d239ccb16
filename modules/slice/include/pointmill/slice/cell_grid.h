// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <Eigen/Core>

namespace pointmill {

/// @brief The geometry of a regular XY grid of square cells [mm].
struct CellGrid {
  double x0 = 0, y0 = 0; ///< outer corner of cell (0, 0): Gridstart
  double cell = 1;       ///< edge of a cell
  int columns = 0, rows = 0;

  /// @brief The grid that covers [@p min, @p max] from its lower corner on.
  static CellGrid
  covering(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell);

  /// @brief The grid that an organised map was made on.
  /// @throws DataError where @p map is not an organised grid of square cells
  static CellGrid of(const CellCloud& map);

  double x(int column) const { return x0 + (column + 0.5) * cell; }
  double y(int row) const { return y0 + (row + 0.5) * cell; }
  int columnOf(double px) const;
  int rowOf(double py) const;
  bool has(int column, int row) const
  {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  std::size_t size() const { return static_cast<std::size_t>(columns) * rows; }
  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * columns + column;
  }
};

} // namespace pointmill
