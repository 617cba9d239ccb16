// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/slice/cell_grid.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Values of the cells of a grid, NaN where there is none.
using FieldValues = std::vector<float>;

/// @brief The heights of @p cells at the centres of @p grid, between their own centres
/// where the ground is no step.
FieldValues heightsAt(const CellGrid& grid, const CellCloud& cells);

/// @brief In each cell the intensity that is farthest off zero.
FieldValues extremesIn(const CellGrid& grid,
                       const pcl::PointCloud<pcl::PointXYZI>& points);

/// @brief Values as whole steps of two bytes, which are enough for all between low and
/// high.
struct PackedField {
  double low = 0, step = 1;
  std::string bytes; ///< little-endian; 65535: none
};
PackedField packed(const FieldValues& values, double low, double high);

} // namespace pointmill
