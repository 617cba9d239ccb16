// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "planes.h"

#include <pointmill/slice/z_slices.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Ground is level where it does not rise more than this share of the step-down from
/// one node to the next; a level of its own must save as much at least.
constexpr double kLevel = 0.1;
constexpr double kRounding = 1e-4; // of float32 [mm]

/// Heights of the nodes that the tool stands on level ground at, with stock above.
std::vector<float> levelGround(const LevelMap& map, double rise)
{
  const CellGrid& grid = map.grid();
  std::vector<float> heights;
  for (int row = 1; row + 1 < grid.rows; ++row)
    for (int column = 1; column + 1 < grid.columns; ++column) {
      const double z = map.lowest({column, row});
      if (!(map.stockTop({column, row}) > z))
        continue;
      bool level = std::isfinite(z);
      for (int dr = -1; level && dr <= 1; ++dr)
        for (int dc = -1; level && dc <= 1; ++dc)
          level = std::abs(map.lowest({column + dc, row + dr}) - z) <= rise;
      if (level)
        heights.push_back(static_cast<float>(z));
    }
  std::sort(heights.begin(), heights.end());
  return heights;
}

} // namespace

std::vector<Plane> planesOf(
    const LevelMap& map, double floor, double top, double step_down, double min_flat)
{
  ZSlices slices;
  slices.setZLimits(floor, top);
  slices.setPitch(step_down);
  std::vector<float> ground;
  const double rise = kLevel * step_down;
  if (min_flat > 0)
    ground = levelGround(map, rise);
  const double cell = map.grid().cell;
  const auto fewest = static_cast<std::ptrdiff_t>(std::ceil(min_flat / (cell * cell)));

  std::vector<Plane> planes;
  double above = top;
  for (const double z : slices.levels()) {
    // Most ground within a rise, of that above this level, where the tool cannot go
    // down to it, and below the last one.
    auto low = std::upper_bound(ground.begin(), ground.end(), z + kRounding);
    const auto end = std::lower_bound(low, ground.end(), above - rise);
    std::ptrdiff_t most = std::max<std::ptrdiff_t>(fewest, 1) - 1;
    double flat = above;
    for (auto high = low; high != end; ++high) {
      while (*high - *low > rise)
        ++low;
      if (high - low + 1 > most) {
        most = high - low + 1;
        flat = *high;
      }
    }
    if (flat < above)
      planes.push_back({flat, z});
    planes.push_back({z});
    above = z;
  }
  return planes;
}

} // namespace pointmill
