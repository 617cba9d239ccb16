// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "region_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pointmill {
namespace {

/// Calls visit(index of the node) for places along a path, a cell apart at most.
template <typename Visit>
void forNodes(const LevelMap& map, const LevelPath& path, Visit&& visit)
{
  const CellGrid& grid = map.grid();
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Eigen::Vector3d& a = path.points[i > 0 ? i - 1 : 0].at;
    const Eigen::Vector3d& b = path.points[i].at;
    const int steps = 1 + static_cast<int>((b - a).head<2>().norm() / grid.cell);
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector3d p = a + (b - a) * (double(k) / steps);
      const int column = std::clamp(grid.columnOf(p.x()), 0, grid.columns - 1);
      const int row = std::clamp(grid.rowOf(p.y()), 0, grid.rows - 1);
      visit(grid.index(column, row));
    }
  }
}

} // namespace

std::vector<std::size_t> byRegion(const LevelMap& map,
                                  const std::vector<int>& regions,
                                  const std::vector<RoughPass>& passes)
{
  // A pass that crosses from one region into another makes them one; by the air
  // between, 0, it does not.
  std::vector<int> joined(*std::max_element(regions.begin(), regions.end()) + 1);
  std::iota(joined.begin(), joined.end(), 0);
  const auto find = [&](int r) {
    while (joined[r] != r)
      r = joined[r] = joined[joined[r]];
    return r;
  };
  std::vector<int> region;
  for (const auto& pass : passes) {
    int mine = -1;
    forNodes(map, pass.path, [&](std::size_t node) {
      const int r = find(regions[node]);
      if (r == 0)
        return;
      if (mine < 0)
        mine = r;
      joined[std::max(find(mine), r)] = std::min(find(mine), r);
    });
    region.push_back(std::max(mine, 0));
  }
  std::vector<std::size_t> order(passes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return find(region[a]) < find(region[b]);
  });
  return order;
}

} // namespace pointmill
