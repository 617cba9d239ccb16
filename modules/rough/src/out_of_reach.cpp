// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "out_of_reach.h"

#include <pointmill/slice/cell_regions.h>
#include <pointmill/slice/distance_field.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// How much the ground rises or falls to the cells beside: nodes do not lie where the
/// tool would touch a slope, and that much is left on it.
double rise(const CellGrid& grid, const std::vector<float>& ground, std::size_t i)
{
  const int column = static_cast<int>(i % grid.columns);
  const int row = static_cast<int>(i / grid.columns);
  double most = 0;
  for (const Node step : {Node{1, 0}, Node{-1, 0}, Node{0, 1}, Node{0, -1}}) {
    const Node to = Node{column, row} + step;
    if (grid.has(to.column, to.row))
      most = std::max<double>(
          most, std::abs(ground[grid.index(to.column, to.row)] - ground[i]));
  }
  return most;
}

} // namespace

OutOfReach outOfReach(const LevelMap& map,
                      const CellCloud& cells,
                      double allowance,
                      double floor,
                      double depth)
{
  const CellGrid& grid = map.grid();
  const double area = grid.cell * grid.cell;
  std::vector<float> ground(grid.size(), static_cast<float>(floor));
  for (const auto& cell : cells)
    if (cell.getState() != CellState::Empty)
      ground[grid.index(grid.columnOf(cell.x), grid.rowOf(cell.y))] =
          static_cast<float>(std::max<double>(cell.z + allowance, floor));

  OutOfReach result;
  const auto free = map.reach(false, false), reach = map.reach(true, false);
  std::vector<unsigned char> thick(grid.size()), core(grid.size());
  const auto standing = [&](std::size_t i) {
    return map.standing(
        {static_cast<int>(i % grid.columns), static_cast<int>(i / grid.columns)});
  };
  const auto left = [&](const std::vector<float>& down_to, std::size_t i) {
    return std::min<double>(standing(i), down_to[i]) - ground[i];
  };
  for (std::size_t i = 0; i < thick.size(); ++i) {
    thick[i] = left(free, i) > depth + rise(grid, ground, i);
    const double low = std::max<double>(free[i], ground[i]);
    const double kept = std::min<double>(standing(i), reach[i]) - low;
    if (kept > 0)
      result.kept_out_volume += kept * area;
  }
  // The allowance, and what the cells cost, stays along every wall.
  const double skin = allowance / grid.cell + 2;
  std::vector<unsigned char> thin(thick.size());
  for (std::size_t i = 0; i < thick.size(); ++i)
    thin[i] = !thick[i];
  const auto inside = distanceField(thin, grid.columns, grid.rows);
  for (std::size_t i = 0; i < core.size(); ++i)
    core[i] = thick[i] && inside[i] > skin;
  const auto to_core = distanceField(core, grid.columns, grid.rows);
  for (std::size_t i = 0; i < core.size(); ++i)
    thick[i] = thick[i] && to_core[i] <= skin;

  for (const auto& piece : cellRegions(grid, thick, Connected::Corners)) {
    NarrowPlace place;
    std::size_t widest = piece.front();
    for (const auto i : piece) {
      place.area += area;
      place.volume += left(free, i) * area;
      if (inside[i] > inside[widest])
        widest = i;
    }
    place.at = {grid.x(static_cast<int>(widest % grid.columns)),
                grid.y(static_cast<int>(widest / grid.columns)),
                ground[widest]};
    result.narrow_volume += place.volume;
    result.narrow.push_back(place);
  }
  std::stable_sort(result.narrow.begin(),
                   result.narrow.end(),
                   [](const auto& a, const auto& b) { return a.volume > b.volume; });
  return result;
}

} // namespace pointmill
