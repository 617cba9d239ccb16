// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "wall_lines.h"

// Boost 1.74 includes a header of its own that it calls deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

constexpr int kHalvings = 4;

} // namespace

std::vector<IsoLine> wallLines(const Level& level)
{
  const LevelMap& map = level.map();
  const CellGrid& grid = map.grid();
  std::vector<unsigned char> free(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      free[grid.index(column, row)] = level.isFree({column, row});
  // Where less is free, further down, the lines lie within these; chords would cross.
  return isoLines(grid, free, [&](Node in, Node out) {
    Eigen::Vector2d good = map.at(in), bad = map.at(out);
    for (int i = 0; i < kHalvings; ++i) {
      const Eigen::Vector2d middle = (good + bad) / 2;
      (map.lowestAt(middle) <= level.z() ? good : bad) = middle;
    }
    return good;
  });
}

IsoLine straightened(const Level& level, const IsoLine& line, double tolerance)
{
  namespace bg = boost::geometry;
  using Place = bg::model::d2::point_xy<double>;
  auto points = line.points;
  if (line.closed)
    points.push_back(points.front());
  bg::model::linestring<Place> all, few;
  for (const auto& p : points)
    all.emplace_back(p.x(), p.y());
  bg::simplify(all, few, tolerance);

  const double cell = level.map().grid().cell;
  IsoLine straight{{points.front()}, line.closed};
  const auto goTo = [&](const Eigen::Vector2d& to) {
    const Eigen::Vector2d from = straight.points.back();
    const int steps = static_cast<int>(std::ceil((to - from).norm() / cell));
    for (int i = 1; i < steps; ++i)
      straight.points.push_back(from + (to - from) * (double(i) / steps));
    straight.points.push_back(to);
  };
  std::size_t at = 0;
  for (std::size_t k = 1; k < few.size() && at + 1 < points.size(); ++k) {
    std::size_t to = at + 1;
    while (to + 1 < points.size() &&
           (points[to].x() != few[k].x() || points[to].y() != few[k].y()))
      ++to;
    const bool proven = to == at + 1 || level.isFree(points[at], points[to]) ||
                        level.isFreeOfPoints(points[at], points[to]);
    for (std::size_t i = proven ? to : at + 1; i <= to; ++i)
      goTo(points[i]);
    at = to;
  }
  if (line.closed && straight.points.size() > 1)
    straight.points.pop_back();
  return straight;
}

std::vector<Eigen::Vector2d> corners(const std::vector<Eigen::Vector2d>& points)
{
  std::vector<Eigen::Vector2d> kept;
  for (const auto& p : points) {
    if (kept.size() >= 2) {
      const Eigen::Vector2d u = kept.back() - kept[kept.size() - 2],
                            v = p - kept.back();
      const double across = u.x() * v.y() - u.y() * v.x();
      if (std::abs(across) <= 1e-9 * u.norm() * v.norm() && u.dot(v) > 0)
        kept.pop_back();
    }
    if (kept.empty() || kept.back() != p)
      kept.push_back(p);
  }
  return kept;
}

bool isSetNear(const CellGrid& grid,
               const std::vector<unsigned char>& nodes,
               const Eigen::Vector2d& p)
{
  const double half = grid.cell / 2;
  const int column = grid.columnOf(p.x() - half), row = grid.rowOf(p.y() - half);
  for (int r = row; r <= row + 1; ++r)
    for (int c = column; c <= column + 1; ++c)
      if (grid.has(c, r) && nodes[grid.index(c, r)])
        return true;
  return false;
}

std::vector<IsoLine>
neededStretches(const IsoLine& line,
                const std::function<bool(const Eigen::Vector2d&)>& needed,
                double gap)
{
  std::vector<Eigen::Vector2d> points = line.points;
  if (line.closed) {
    // Begin where nothing is needed, if anywhere, behind the longest such stretch.
    const std::size_t n = points.size();
    std::size_t best = n, longest = 0, run = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      run = needed(points[i % n]) ? 0 : run + 1;
      if (run > longest && run <= n) {
        longest = run;
        best = i % n;
      }
    }
    if (longest == 0)
      return {line};
    std::rotate(points.begin(), points.begin() + best, points.end());
    points.push_back(points.front());
  }
  std::vector<IsoLine> stretches;
  double idle = 0;
  std::size_t first = 0, last = 0;
  bool open = false;
  const auto close = [&] {
    if (open)
      stretches.push_back({{points.begin() + (first > 0 ? first - 1 : 0),
                            points.begin() + std::min(last + 2, points.size())},
                           false});
    open = false;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0)
      idle += (points[i] - points[i - 1]).norm();
    if (!needed(points[i]))
      continue;
    if (open && i > last + 1 && idle > gap)
      close();
    if (!open)
      first = i;
    open = true;
    last = i;
    idle = 0;
  }
  close();
  return stretches;
}

} // namespace pointmill
