// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/page_allocator.h>

#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pointmill {

/// @brief Points somewhere in memory: coordinate k of the i-th is
/// `xyz[k][stride * (indices ? indices[i] : i)]`.
struct PointSource {
  const float* xyz[3];
  std::size_t stride; ///< from one point to the next [floats]
  const pcl::index_t* indices;
  std::size_t count;
};

/// @brief Square cells in rows over a rectangle in XY. What lies beside it belongs to
/// the cells of its rim.
struct CellFrame {
  double x0 = 0, y0 = 0, cell = 1, per_mm = 1; ///< lower corner, edge, 1 / edge
  int columns = 1, rows = 1;

  int column(double x) const { return place((x - x0) * per_mm, columns); }
  int row(double y) const { return place((y - y0) * per_mm, rows); }

private:
  static int place(double at, int count) // NaN is put into the first
  {
    const double low = at > 0.0 ? at : 0.0, last = count - 1;
    return static_cast<int>(low < last ? low : last);
  }
};

/// @brief Points in the order of their cells, row by row; within a cell in the order of
/// the input. The columns have `kPad` numbers more than points, which are no points.
struct SortedPoints {
  using Column = std::vector<float, PageAllocator<float>>;
  static constexpr std::size_t kPad = 16;

  Column x, y, z;
  std::vector<std::uint32_t, PageAllocator<std::uint32_t>> start; ///< cells, and one
  CellFrame frame;
  Eigen::Vector3d min, max;

  std::size_t size() const { return start.back(); }
};

} // namespace pointmill
