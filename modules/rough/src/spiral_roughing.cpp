// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "border.h"
#include "stay_down.h"
#include "stretches.h"

#include <pointmill/rough/spiral_roughing.h>

#include <algorithm>
#include <unordered_map>

namespace pointmill {
namespace {

/// The nodes of a rectangle, anticlockwise from its lower left corner, which is
/// repeated at the end.
Chain rectangle(Node low, Node high)
{
  Chain ring{low};
  const auto go = [&](Node to, int d) {
    while (ring.back() != to)
      ring.push_back(ring.back() + direction(d));
  };
  go({high.column, low.row}, 0);
  go(high, 1);
  go({low.column, high.row}, 2);
  go(low, 3);
  return ring;
}

/// Follows the ring from `from` on; round the part, clockwise, where it is in the way.
/// Stops where there is no way on and sets `from` to the next place to begin at.
Chain follow(const Level& level, const Chain& ring, std::size_t& from)
{
  std::unordered_map<std::size_t, std::size_t> place; // of a node on the ring
  for (std::size_t i = 0; i < ring.size(); ++i)
    place[level.map().grid().index(ring[i].column, ring[i].row)] = i;

  while (from < ring.size() && !level.isFree(ring[from]))
    ++from;
  Chain chain;
  while (from < ring.size()) {
    if (level.isFree(ring[from])) {
      chain.push_back(ring[from++]);
      continue;
    }
    const Node here = chain.back();
    const Node blocked = ring[from];
    int wall = 0;
    while (here + direction(wall) != blocked)
      ++wall;
    BorderWalker walker{level, here, wall};
    Chain detour;
    // Back on the ring counts only where it goes on next: nothing of it is left out.
    std::size_t next = from;
    while (next < ring.size() && !level.isFree(ring[next]))
      ++next;
    const std::size_t longest = level.map().grid().size();
    bool back_on = false;
    do {
      walker.step();
      if (detour.empty() || detour.back() != walker.at)
        detour.push_back(walker.at);
      const auto on =
          place.find(level.map().grid().index(walker.at.column, walker.at.row));
      if (on != place.end() && on->second == next) {
        from = on->second + 1;
        back_on = true;
      }
    } while (!back_on && detour.size() < longest &&
             !(walker.at == here && walker.wall == wall));
    if (!back_on)
      return chain;
    chain.insert(chain.end(), detour.begin(), detour.end());
  }
  return chain;
}

/// The stretches of a path that cut what no contour before it has; those less than
/// `gap` nodes apart stay together.
void keepNeeded(const Level& level,
                const Chain& path,
                int gap,
                Material& material,
                std::vector<LevelPath>& paths)
{
  const auto cuts = [&](Node n) {
    return level.isNeeded(n) &&
           material.toCut(level.map().at(n), material.certainRadius(), 0) > 0;
  };
  const int size = static_cast<int>(path.size());
  const std::size_t known = paths.size();
  neededStretches(
      0,
      size,
      gap,
      [&](int i) { return cuts(path[i]); },
      [&](int first, int last) { // with a node more at each end
        paths.push_back(pathAlong(level,
                                  {path.begin() + std::max(0, first - 1),
                                   path.begin() + std::min(size - 1, last + 1) + 1}));
      });
  for (std::size_t i = known; i < paths.size(); ++i)
    material.cut(paths[i]);
}

} // namespace

std::vector<LevelPath> SpiralRoughing::clearLevel(const Level& level, Report&) const
{
  const int step = level.stride();
  std::vector<LevelPath> paths;
  Material material(level);
  Node low{0, 0}, high{level.map().grid().columns - 1, level.map().grid().rows - 1};
  for (;;) {
    const Chain ring = rectangle(low, high);
    for (std::size_t from = 0; from < ring.size();)
      keepNeeded(level, follow(level, ring, from), step, material, paths);
    // Two sides no further apart than a step leave nothing between them.
    const int wide = high.column - low.column, deep = high.row - low.row;
    if (std::min(wide, deep) <= step)
      break;
    const Node in{std::min(step, wide / 2), std::min(step, deep / 2)};
    low = low + in;
    high = high + Node{-in.column, -in.row};
  }
  Material before(level, 1);
  return joinPaths(level, before, std::move(paths));
}

std::vector<LevelPath> SpiralRoughing::clearRest(const Level& level,
                                                 Material& material) const
{
  Material before = material;
  return shortRest(level, before, LevelRoughing::clearRest(level, material));
}

} // namespace pointmill
