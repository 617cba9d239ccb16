// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What a strategy leaves on its level: ridges beside walls first, then anything else.
#include "border.h"
#include "stretches.h"

#include <pointmill/common/watch.h>
#include <pointmill/rough/level_roughing.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr int kMostRounds = 4;

/// The stretches of a chain from where there is something to cut, with a node more at
/// each end, so that none is a mere point.
template <typename Needed>
void addStretches(const Level& level,
                  const Chain& chain,
                  int gap,
                  Needed&& needed,
                  Material& material,
                  std::vector<LevelPath>& paths)
{
  const int size = static_cast<int>(chain.size());
  neededStretches(
      0,
      size,
      gap,
      [&](int i) { return needed(chain[i]); },
      [&](int first, int last) {
        const Chain piece(chain.begin() + std::max(0, first - 1),
                          chain.begin() + std::min(size - 1, last + 1) + 1);
        if (piece.size() < 2)
          return;
        paths.push_back(pathAlong(level, piece));
        material.cut(paths.back());
      });
}

/// The free stretches of every stride-th row.
std::vector<Chain> freeRows(const Level& level, int stride)
{
  const CellGrid& grid = level.map().grid();
  std::vector<Chain> rows;
  for (int row = 0; row < grid.rows; row += stride) {
    rows.emplace_back();
    for (int column = 0; column < grid.columns; ++column) {
      if (level.isFree({column, row}))
        rows.back().push_back({column, row});
      else if (!rows.back().empty())
        rows.emplace_back();
    }
  }
  return rows;
}

} // namespace

std::vector<LevelPath> LevelRoughing::clearRest(const Level& level,
                                                Material& material) const
{
  std::vector<LevelPath> paths;
  std::vector<unsigned char> cuts;
  const auto needed = [&](Node n) {
    return level.isNeeded(n) && cuts[level.map().index(n)];
  };
  for (int round = 0; round < kMostRounds && material.left() > 0; ++round) {
    cuts = material.nodesToCut();
    const auto chains = round == 0 ? borderLoops(level)
                                   : freeRows(level, round == 1 ? level.stride() : 1);
    for (const auto& chain : chains) {
      checkInterrupted();
      const std::size_t before = material.left();
      addStretches(level, chain, level.stride(), needed, material, paths);
      if (material.left() < before && round > 0) // a row clears its neighbours' too
        cuts = material.nodesToCut();
    }
  }
  return paths;
}

} // namespace pointmill
