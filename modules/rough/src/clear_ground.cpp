// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "clear_ground.h"

#include "border.h"

#include <pointmill/slice/distance_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;

constexpr double kThickestSkin = 0.15; // of the radius
constexpr double kNear = 1.5;          // of the radius: what a start depends on
/// A front goes on beyond so many radii of something else.
constexpr double kInterruption = 0.3;
constexpr double kCrumb = 0.02; // of the radius squared: not worth a walk
constexpr double kPlace = 2;    // of the radius: what is taken together for that
constexpr double kBanned = 0.1; // of the radius: as good as the same start
/// There is nothing to cut at a node, for good.
constexpr Material::Place kNothing{-2, -2};

} // namespace

Node Front::beyond() const
{
  return at + pointmill::direction(direction);
}

ClearGround::ClearGround(const Level& level, const Material& material, double side)
    : level_(level), material_(material), side_(side)
{
  const CellGrid& grid = level.map().grid();
  const double radius = level.map().endRadius();
  const double skin = std::min(grid.cell, kThickestSkin * radius);
  front_radius_ = radius - skin;
  clear_radius_ = radius - skin / 2;
  crumb_ = kCrumb * radius * radius;
  clear_.assign(grid.size(), 0);
  crumbs_ = clear_;
  obstacle_.assign(grid.size(), {-1, -1});
  work_ = obstacle_;
  seen_.assign(grid.size(), 0);
  banned_.assign(grid.size(), 0);
  from_.assign(grid.size(), 0);
  known_.assign(4 * grid.size(), 0);
  begins_ = known_;
  done_.assign(4 * grid.size(), 0);
  clearFarOff();
}

/// Far from all that stands everything is clear.
void ClearGround::clearFarOff()
{
  const CellGrid &grid = level_.map().grid(), &cells = material_.grid();
  const int parts = cells.columns / grid.columns;
  std::vector<unsigned char> stands(grid.size(), 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const int middle = parts / 2; // all parts of a cell are alike at first
      stands[grid.index(column, row)] =
          material_.at(column * parts + middle, row * parts + middle) != Material::Air;
    }
  const auto away = distanceField(stands, grid.columns, grid.rows);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t i = grid.index(column, row);
      if (level_.isFree(Node{column, row}) &&
          away[i] * grid.cell > clear_radius_ + grid.cell)
        clear_[i] = 1;
    }
}

bool ClearGround::isClear(Node n)
{
  if (!level_.map().has(n))
    return false;
  unsigned char& known = clear_[level_.map().index(n)];
  if (!known) {
    if (!level_.isFree(n))
      return false;
    Material::Place& obstacle = obstacle_[level_.map().index(n)];
    if (obstacle.row >= 0 &&
        material_.at(obstacle.column, obstacle.row) != Material::Air)
      return false;
    const auto found = material_.anyStanding(level_.map().at(n), clear_radius_);
    if (found)
      obstacle = *found;
    known = !found;
  }
  return known;
}

bool ClearGround::isToCut(Node n)
{
  if (!level_.isFree(n))
    return false;
  Material::Place& work = work_[level_.map().index(n)];
  if (work.row == kNothing.row)
    return false;
  if (work.row >= 0 && material_.at(work.column, work.row) == Material::ToCut)
    return true;
  const auto found = material_.anyToCut(level_.map().at(n), front_radius_);
  work = found.value_or(kNothing);
  return found.has_value();
}

/// What a start at the node depends on, as a number.
unsigned ClearGround::standingNear(Node n) const
{
  const Vector2d p = level_.map().at(n);
  return static_cast<unsigned>(material_.standing(
      p, p, kNear * front_radius_, std::numeric_limits<std::size_t>::max()));
}

bool ClearGround::isCrumb(Node n)
{
  unsigned char& known = crumbs_[level_.map().index(n)];
  if (!known) {
    const double cell = material_.grid().cell;
    const auto crumb = static_cast<std::size_t>(crumb_ / (cell * cell));
    known = material_.toCut(level_.map().at(n), kPlace * front_radius_, crumb) <= crumb;
  }
  return known;
}

bool ClearGround::isFront(const Front& edge)
{
  const Node n = edge.beyond();
  unsigned char& done = done_[keyOf(edge)];
  if (done)
    return false;
  // The nodes may lie so that the next one only brushes what stands there.
  done = !level_.isFree(n) || isClear(n) ||
         (!isToCut(n) && !isToCut(n + direction(edge.direction))) || isCrumb(n);
  if (done)
    return false;
  const unsigned banned = banned_[level_.map().index(n)];
  return banned == 0 || banned != 1 + standingNear(n);
}

std::size_t ClearGround::keyOf(const Front& edge) const
{
  return 4 * level_.map().index(edge.at) + static_cast<std::size_t>(edge.direction);
}

bool ClearGround::isClear(const Vector2d& a, const Vector2d& b) const
{
  return level_.isFree(a, b) && material_.isClear(a, b, clear_radius_);
}

void ClearGround::ban(Node n)
{
  const CellGrid& grid = level_.map().grid();
  const int reach = static_cast<int>(kBanned * front_radius_ / grid.cell);
  for (int row = n.row - reach; row <= n.row + reach; ++row)
    for (int column = n.column - reach; column <= n.column + reach; ++column)
      if (grid.has(column, row))
        banned_[grid.index(column, row)] = 1 + standingNear({column, row});
}

std::optional<Front> ClearGround::next(const Vector2d& from, std::vector<Node>& way)
{
  const CellGrid& grid = level_.map().grid();
  ++search_;
  std::vector<std::size_t> open;
  const auto push = [&](Node n, std::size_t before) {
    const std::size_t i = grid.index(n.column, n.row);
    seen_[i] = search_;
    from_[i] = before;
    open.push_back(i);
  };
  constexpr auto kStart = std::numeric_limits<std::size_t>::max();
  const int column = grid.columnOf(from.x()), row = grid.rowOf(from.y());
  constexpr int kAround = 2;
  for (int r = row - kAround; r <= row + kAround; ++r)
    for (int c = column - kAround; c <= column + kAround; ++c)
      if (isClear(Node{c, r}) && isClear(from, level_.map().at({c, r})))
        push({c, r}, kStart);
  std::sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
    const auto away = [&](std::size_t i) {
      const Node n{int(i % grid.columns), int(i / grid.columns)};
      return (level_.map().at(n) - from).squaredNorm();
    };
    const double da = away(a), db = away(b);
    return da != db ? da < db : a < b;
  });
  for (std::size_t k = 0; k < open.size(); ++k) {
    const std::size_t i = open[k];
    const Node n{int(i % grid.columns), int(i / grid.columns)};
    for (int d = 0; d < 4; ++d) {
      const Node on = n + direction(d);
      if (isClear(on)) {
        if (seen_[grid.index(on.column, on.row)] != search_)
          push(on, i);
      }
      else if (known_[keyOf({n, d})] != search_ && isFront({n, d}))
        markBeginning({n, d});
    }
    for (int d = 0; d < 4; ++d)
      if (begins_[keyOf({n, d})] == search_) {
        way.clear();
        for (std::size_t j = i; j != kStart; j = from_[j])
          way.push_back({int(j % grid.columns), int(j / grid.columns)});
        std::reverse(way.begin(), way.end());
        return Front{n, d};
      }
  }
  return {};
}

/// Where the stretch of a front that is not known yet begins.
void ClearGround::markBeginning(const Front& front)
{
  known_[keyOf(front)] = search_;
  bool joins = false;
  std::vector<Node> way;
  const Front begin = traced(front, way, [&](const Front& edge) {
    joins = known_[keyOf(edge)] == search_;
    known_[keyOf(edge)] = search_;
    return !joins;
  });
  if (!joins)
    begins_[keyOf(begin)] = search_;
}

std::vector<Vector2d>
ClearGround::brush(const Vector2d& from, const std::vector<Node>& to, std::size_t most)
{
  // From the goals, so that the way comes out forwards.
  const LevelMap& map = level_.map();
  const CellGrid& grid = map.grid();
  const auto is_open = [&](Node n) {
    return isClear(n) ||
           (level_.isFree(n) &&
            material_.standing(map.at(n), map.at(n), clear_radius_, most) <= most);
  };
  std::vector<std::size_t> next(grid.size(), grid.size()), open;
  for (const Node n : to)
    if (is_open(n)) {
      open.push_back(map.index(n));
      next[open.back()] = open.back();
    }
  const auto node = [&](std::size_t i) {
    return Node{int(i % grid.columns), int(i / grid.columns)};
  };
  for (std::size_t k = 0; k < open.size(); ++k) {
    const Node n = node(open[k]);
    if ((map.at(n) - from).norm() < 2 * grid.cell && level_.isFree(from, map.at(n))) {
      std::vector<Vector2d> way{from};
      for (std::size_t i = open[k];; i = next[i]) {
        way.push_back(map.at(node(i)));
        if (next[i] == i)
          return way;
      }
    }
    for (int d = 0; d < 4; ++d) {
      const Node other = n + direction(d);
      if (map.has(other) && next[map.index(other)] == grid.size() && is_open(other)) {
        next[map.index(other)] = open[k];
        open.push_back(map.index(other));
      }
    }
  }
  return {};
}

std::optional<Front> ClearGround::anywhere(const Vector2d& from)
{
  const CellGrid& grid = level_.map().grid();
  const auto cuts = material_.nodesToCut(front_radius_);
  std::optional<Front> best;
  double least = std::numeric_limits<double>::infinity();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Node n{column, row};
      if (!cuts[grid.index(column, row)] || !level_.isFree(n))
        continue;
      for (int d = 0; d < 4; ++d) { // from the next node or the one after it
        Front edge{n, d};
        for (int back = 1; back <= 2; ++back) {
          edge.at = edge.at + direction(d + 2);
          const double away = (level_.map().at(edge.at) - from).squaredNorm();
          if (away < least && isClear(edge.at) && isFront(edge)) {
            best = edge;
            least = away;
          }
        }
      }
    }
  return best;
}

/// One node back along the edge of the clear ground, the material on the other side.
Front ClearGround::before(Front at, std::vector<Node>& way)
{
  const int left = side_ > 0 ? 1 : 3;
  const int forward = (at.direction + 4 - left) & 3;
  const Node ahead = at.at + direction(forward);
  const Node corner = ahead + direction(at.direction);
  if (!isClear(ahead))
    at.direction = forward;
  else if (!isClear(corner))
    at.at = ahead;
  else {
    way.push_back(ahead);
    at.at = corner;
    at.direction = (forward + 2) & 3;
  }
  if (way.empty() || way.back() != at.at)
    way.push_back(at.at);
  return at;
}

/// Back along a front to its beginning, as long as go_on(edge) holds.
template <typename GoOn>
Front ClearGround::traced(const Front& front, std::vector<Node>& way, GoOn&& go_on)
{
  const CellGrid& grid = level_.map().grid();
  Front at = front, begin = front;
  const std::size_t most = 4 * grid.size(), length = way.size();
  std::size_t kept = length;
  double gap = 0;
  for (std::size_t i = 0; i < most; ++i) {
    at = before(at, way);
    if (at.at == front.at && at.direction == front.direction) {
      way.resize(length); // round in a ring
      return front;
    }
    gap += grid.cell;
    if (isFront(at)) {
      begin = at;
      kept = way.size();
      gap = 0;
      if (!go_on(at))
        break;
    }
    if (gap > kInterruption * front_radius_ + 2 * grid.cell)
      break;
  }
  way.resize(kept);
  return begin;
}

Front ClearGround::beginning(const Front& front, std::vector<Node>& way)
{
  return traced(front, way, [](const Front&) { return true; });
}

} // namespace pointmill
