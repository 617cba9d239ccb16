// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stay_down.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace pointmill {
namespace {

/// Ways of the tool over nodes of a level that are free and clear of material.
class Ways {
public:
  Ways(const Level& level, const Material& material) : level_(level), material_(material)
  {
  }

  /// The shortest way over neighbouring nodes (A*), empty if it is longer than `most`.
  Chain find(Node from, Node to, double most) const
  {
    const CellGrid& grid = level_.map().grid();
    struct Seen {
      double way;
      std::size_t before;
    };
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<Open>> open;
    std::unordered_map<std::size_t, Seen> seen;
    const auto node = [&](std::size_t i) {
      return Node{static_cast<int>(i) % grid.columns, static_cast<int>(i) / grid.columns};
    };
    const std::size_t goal = level_.map().index(to);
    const std::size_t start = level_.map().index(from);
    seen[start] = {0, start};
    open.push({estimate(from, to), start});
    while (!open.empty()) {
      const auto [sum, i] = open.top();
      open.pop();
      if (sum * grid.cell > most)
        return {};
      if (i == goal)
        break;
      const Node at = node(i);
      const double way = seen[i].way;
      if (sum > way + estimate(at, to) + 1e-9)
        continue; // a better way was found since
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          const Node next = at + Node{dc, dr};
          if (next == at || !(next == to || isClear(next)) || !mayStep(at, dc, dr))
            continue;
          const double longer = way + std::hypot(dc, dr);
          const std::size_t k = level_.map().index(next);
          const auto it = seen.find(k);
          if (it != seen.end() && it->second.way <= longer + 1e-9)
            continue;
          seen[k] = {longer, i};
          open.push({longer + estimate(next, to), k});
        }
    }
    if (seen.find(goal) == seen.end())
      return {};
    Chain chain{to};
    for (std::size_t i = goal; i != start; chain.push_back(node(i)))
      i = seen[i].before;
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

private:
  bool isClear(Node n) const
  {
    return level_.isFree(n) && material_.at(level_.map().at(n)) == Material::Air;
  }
  /// Between nodes the tool is safe in squares whose corners are all free.
  bool mayStep(Node at, int dc, int dr) const
  {
    return level_.isFree(at + Node{dc, 0}) && level_.isFree(at + Node{0, dr});
  }
  static double estimate(Node a, Node b)
  {
    const double dx = std::abs(a.column - b.column), dy = std::abs(a.row - b.row);
    return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
  }

  const Level& level_;
  const Material& material_;
};

Node nodeAt(const Level& level, const PathPoint& p)
{
  const CellGrid& grid = level.map().grid();
  return {grid.columnOf(p.at.x()), grid.rowOf(p.at.y())};
}

} // namespace

std::vector<LevelPath> joinPaths(const Level& level,
                                 Material& material,
                                 std::vector<LevelPath> paths,
                                 double most)
{
  std::vector<LevelPath> joined;
  const Ways ways(level, material);
  for (auto& path : paths) {
    Chain way;
    if (!joined.empty()) {
      const Node from = nodeAt(level, joined.back().points.back());
      const Node to = nodeAt(level, path.points.front());
      way = ways.find(from, to, most);
    }
    material.cut(path);
    if (way.empty()) {
      joined.push_back(std::move(path));
      continue;
    }
    const LevelPath link = pathAlong(level, way);
    material.cut(link);
    auto& points = joined.back().points;
    points.insert(points.end(), link.points.begin() + 1, link.points.end());
    points.insert(points.end(), path.points.begin() + 1, path.points.end());
    joined.back().reversible = joined.back().reversible && path.reversible;
  }
  return joined;
}

} // namespace pointmill
