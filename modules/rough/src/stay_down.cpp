// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stay_down.h"

#include <pointmill/common/tour.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace pointmill {
namespace {

/// Ways of the tool over nodes of a level that are free and clear of material. None
/// leads from one of the map's regions, each of which is finished from top to bottom,
/// into another.
class Ways {
public:
  Ways(const Level& level, const Material& material)
      : level_(level), material_(material), seen_(level.map().grid().size())
  {
  }

  /// The shortest way over neighbouring nodes (A*), empty if it is longer than `most`.
  Chain find(Node from, Node to, double most)
  {
    const CellGrid& grid = level_.map().grid();
    region_ = level_.region(from);
    if (estimate(from, to) * grid.cell > most || level_.region(to) != region_)
      return {};
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<Open>> open;
    ++search_;
    const auto node = [&](std::size_t i) {
      return Node{static_cast<int>(i) % grid.columns,
                  static_cast<int>(i) / grid.columns};
    };
    const std::size_t goal = level_.map().index(to);
    const std::size_t start = level_.map().index(from);
    seen_[start] = {search_, 0, start};
    open.push({estimate(from, to), start});
    while (!open.empty()) {
      const auto [sum, i] = open.top();
      open.pop();
      if (sum * grid.cell > most)
        return {};
      if (i == goal)
        break;
      const Node at = node(i);
      const double way = seen_[i].way;
      if (sum > way + estimate(at, to) + 1e-9)
        continue; // a better way was found since
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc) {
          const Node next = at + Node{dc, dr};
          if (next == at || !(next == to || isClear(next)) || !mayStep(at, dc, dr))
            continue;
          const double longer = way + std::hypot(dc, dr);
          const std::size_t k = level_.map().index(next);
          Seen& there = seen_[k];
          if (there.search == search_ && there.way <= longer + 1e-9)
            continue;
          there = {search_, longer, i};
          open.push({longer + estimate(next, to), k});
        }
    }
    if (seen_[goal].search != search_)
      return {};
    Chain chain{to};
    for (std::size_t i = goal; i != start; chain.push_back(node(i)))
      i = seen_[i].before;
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

private:
  bool isClear(Node n) const
  {
    return level_.isFree(n) && (level_.region(n) == region_ || level_.region(n) == 0) &&
           material_.at(level_.map().at(n)) == Material::Air;
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

  struct Seen {
    int search = 0; // that the rest is of
    double way = 0; // from its start [nodes]
    std::size_t before = 0;
  };

  const Level& level_;
  const Material& material_;
  std::vector<Seen> seen_; // by node
  int search_ = 0;
  int region_ = 0; // that the search starts in
};

Node nodeAt(const Level& level, const PathPoint& p)
{
  const CellGrid& grid = level.map().grid();
  return {grid.columnOf(p.at.x()), grid.rowOf(p.at.y())};
}

} // namespace

std::vector<LevelPath>
joinPaths(const Level& level, Material& material, std::vector<LevelPath> paths)
{
  std::vector<LevelPath> joined;
  Ways ways(level, material);
  for (auto& path : paths) {
    Chain way;
    if (!joined.empty()) {
      const Node from = nodeAt(level, joined.back().points.back());
      const Node to = nodeAt(level, path.points.front());
      way = ways.find(from, to, retractCost(level));
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

double retractCost(const Level& level)
{
  return 6 * level.map().tool().diameter;
}

double
airBetween(const Level& level, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return (a - b).norm() + (level.isFree(a, b) ? 0 : retractCost(level));
}

std::vector<LevelPath>
shortRest(const Level& level, Material& material, const std::vector<LevelPath>& rest)
{
  std::vector<TourItem> items;
  for (const auto& path : rest) {
    const Eigen::Vector2d in = path.points.front().at.head<2>();
    const Eigen::Vector2d out = path.points.back().at.head<2>();
    items.push_back({{in, out}, {out, in}});
  }
  const auto air = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return airBetween(level, a, b);
  };
  std::vector<LevelPath> paths;
  for (const TourStop& stop : shortTour(items, TourStart::Any, air).stops) {
    paths.push_back(rest[stop.item]);
    if (stop.way > 0)
      std::reverse(paths.back().points.begin(), paths.back().points.end());
  }
  return joinPaths(level, material, std::move(paths));
}

} // namespace pointmill
