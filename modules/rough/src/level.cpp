// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/rough/level.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

namespace {
constexpr double kLittle = 1e-3; // stock that stands no higher is none [mm]
}

Level::Level(const LevelMap& map,
             double z,
             double step_over,
             double below,
             const std::vector<int>* regions)
    : map_(&map), regions_(regions), z_(z), step_over_(step_over),
      state_(map.grid().size(), 0)
{
  const CellGrid& grid = map.grid();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Node n{column, row};
      const double lowest = map.lowest(n);
      if (lowest > z + kTouch)
        continue;
      const bool needed =
          map.stockTop(n) > z + kLittle && (std::isinf(below) || lowest > below);
      state_[map.index(n)] = needed ? kFree | kNeeded : kFree;
      empty_ = empty_ && !needed;
    }
}

int Level::stride() const
{
  return std::max(1,
                  static_cast<int>(std::floor(step_over_ / map_->grid().cell + 1e-6)));
}

std::vector<unsigned char> Level::neededNodes() const
{
  std::vector<unsigned char> needed(state_.size());
  std::transform(state_.begin(), state_.end(), needed.begin(), [](unsigned char s) {
    return static_cast<unsigned char>((s & kNeeded) != 0);
  });
  return needed;
}

LevelPath pathAlong(const Level& level, const Chain& chain)
{
  Chain kept;
  for (const Node n : chain) {
    if (kept.size() >= 2) {
      const Node a = kept[kept.size() - 2], b = kept.back();
      const int ux = b.column - a.column, uy = b.row - a.row;
      const int vx = n.column - b.column, vy = n.row - b.row;
      if (ux * vy == uy * vx && ux * vx + uy * vy > 0) {
        kept.back() = n;
        continue;
      }
    }
    if (kept.empty() || kept.back() != n)
      kept.push_back(n);
  }
  LevelPath path;
  for (const Node n : kept)
    path.points.push_back({level.at(n)});
  return path;
}

} // namespace pointmill
