// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "view_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace pointmill {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint16_t kNoValue = 65535;

/// Between four centres where the ground is no step, else that of the cell.
float heightAt(const CellGrid& grid, const CellCloud& cells, double x, double y)
{
  const int column = grid.columnOf(x), row = grid.rowOf(y);
  if (!grid.has(column, row))
    return kNone;
  const int c = x < grid.x(column) ? column - 1 : column;
  const int r = y < grid.y(row) ? row - 1 : row;
  const float own = cells[grid.index(column, row)].z;
  if (!grid.has(c, r) || !grid.has(c + 1, r + 1))
    return own;
  const float z[] = {cells[grid.index(c, r)].z,
                     cells[grid.index(c + 1, r)].z,
                     cells[grid.index(c, r + 1)].z,
                     cells[grid.index(c + 1, r + 1)].z};
  const auto [low, high] = std::minmax_element(std::begin(z), std::end(z));
  if (!(*high - *low < 2 * grid.cell) ||
      !std::all_of(
          std::begin(z), std::end(z), [](float v) { return std::isfinite(v); }))
    return own;
  const double u = (x - grid.x(c)) / grid.cell, v = (y - grid.y(r)) / grid.cell;
  return static_cast<float>((1 - v) * ((1 - u) * z[0] + u * z[1]) +
                            v * ((1 - u) * z[2] + u * z[3]));
}

} // namespace

FieldValues heightsAt(const CellGrid& grid, const CellCloud& cells)
{
  const CellGrid from = CellGrid::of(cells);
  FieldValues heights(grid.size(), kNone);
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      heights[grid.index(c, r)] = heightAt(from, cells, grid.x(c), grid.y(r));
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
