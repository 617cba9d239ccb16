// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "view_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pointmill {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint16_t kNoValue = 65535;

} // namespace

FieldValues heightsAt(const CellGrid& grid, const CellCloud& cells)
{
  const CellGrid from = CellGrid::of(cells);
  FieldValues heights(grid.size(), kNone);
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const int column = from.columnOf(grid.x(c)), row = from.rowOf(grid.y(r));
      if (from.has(column, row))
        heights[grid.index(c, r)] = cells[from.index(column, row)].z;
    }
  return heights;
}

FieldValues extremesIn(const CellGrid& grid,
                       const pcl::PointCloud<pcl::PointXYZI>& points)
{
  FieldValues values(grid.size(), kNone);
  for (const auto& p : points) {
    const int column = grid.columnOf(p.x), row = grid.rowOf(p.y);
    if (!grid.has(column, row) || std::isnan(p.intensity))
      continue;
    float& value = values[grid.index(column, row)];
    if (!(std::abs(p.intensity) <= std::abs(value)))
      value = p.intensity;
  }
  return values;
}

PackedField packed(const FieldValues& values, double low, double high)
{
  PackedField field;
  field.low = low;
  field.step = std::max(high - low, 1e-9) / (kNoValue - 1);
  field.bytes.reserve(2 * values.size());
  for (const float value : values) {
    std::uint16_t steps = kNoValue;
    if (std::isfinite(value))
      steps = static_cast<std::uint16_t>(
          std::lround((std::clamp<double>(value, low, high) - low) / field.step));
    field.bytes += static_cast<char>(steps & 255);
    field.bytes += static_cast<char>(steps >> 8);
  }
  return field;
}

} // namespace pointmill
