// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "high_speed_plan.h"

#include "border.h"
#include "capsule.h"
#include "high_speed_link.h"
#include "stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// What is steered for, of the limit: the rest is for the cells of the simulation.
constexpr double kTarget = 0.97;
// Shares of the radius of the tool's end.
constexpr double kStep = 0.125;      // of a walk
constexpr double kTightest = 0.2;    // turn of a walk
constexpr double kLinkTurn = 0.4;    // turn of a link
constexpr double kFinest = 1.0 / 24; // cell of the simulation
constexpr int kMostParts = 9;        // of a node's cell, so that it does not cost more
constexpr double kLeastHelix = 0.25; // its radius
constexpr double kMostHelix = 0.75;
constexpr double kShortestTrack = 0.5; // of a ramp forth and back
/// A skin is skimmed off from this thickness on, of a node's cell.
constexpr double kThinnest = 0.3;
constexpr double kFairArea = 0.2; // in squares; of a walk that need not be bettered
/// The widest cut that a walk can be steered by, of the diameter.
constexpr double kWidest = 0.85;

int partsFor(const Level& level)
{
  const double finest = kFinest * level.map().endRadius();
  return std::min(kMostParts, int(std::ceil(level.map().grid().cell / finest)) | 1);
}

WalkLimits limitsOf(const Level& level, double side)
{
  const double r = level.map().endRadius();
  return {r,
          std::min(kTarget * level.stepOver(), kWidest * 2 * r),
          kStep * r,
          kTightest * r,
          side};
}

double headingOf(const Vector2d& a, const Vector2d& b)
{
  return std::atan2(b.y() - a.y(), b.x() - a.x());
}

/// The points that are needed for the polyline to stay within `tolerance`.
std::vector<Vector2d>
simplified(const Level& level, const std::vector<Vector2d>& points, double tolerance)
{
  constexpr std::size_t kMost = 64;
  std::vector<Vector2d> kept{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    std::size_t next = i + 1;
    while (next + 1 < points.size() && next - i < kMost) {
      const Vector2d a = points[i], b = points[next + 1], along = b - a;
      bool near = along.norm() > 0;
      for (std::size_t k = i + 1; near && k <= next; ++k) {
        const Vector2d off = points[k] - a;
        near = std::abs(along.x() * off.y() - along.y() * off.x()) <=
               tolerance * along.norm();
      }
      if (!near || !level.isFree(a, b))
        break;
      ++next;
    }
    kept.push_back(points[next]);
    i = next;
  }
  return kept;
}

/// The way without the places that a straight move can leave out.
template <typename Open>
std::vector<Vector2d> tightened(const std::vector<Vector2d>& way, Open&& open)
{
  std::vector<Vector2d> tight{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t next = i + 1;
    while (next + 1 < way.size() && open(way[i], way[next + 1]))
      ++next;
    tight.push_back(way[next]);
    i = next;
  }
  return tight;
}

} // namespace

HighSpeedPlan::HighSpeedPlan(const Level& level, const HighSpeedSettings& settings)
    : level_(level), settings_(settings), material_(level, partsFor(level)),
      walker_(level, material_, limitsOf(level, settings.side)),
      ground_(level, material_, settings.side), no_entry_(level.map().grid().size(), 0)
{
}

std::vector<LevelPath> HighSpeedPlan::clear()
{
  // Each round cuts something, or rules out a place to start at or to enter at.
  for (;;) {
    std::vector<Node> way;
    if (tool_)
      if (const auto front = ground_.next(tool_->at, way)) {
        if (!cutFrom(*front, way, true))
          ground_.ban(front->beyond());
        continue;
      }
    const Vector2d from = tool_ ? tool_->at : level_.map().at({0, 0});
    if (const auto front = ground_.anywhere(from)) {
      std::vector<Node> there{front->at};
      const Front first = ground_.beginning(*front, there);
      if (!cutFrom(first, there, false)) {
        ground_.ban(first.beyond());
        ground_.ban(front->beyond());
      }
      continue;
    }
    if (!enter())
      break;
  }
  skim();
  std::vector<Node> narrow;
  const CellGrid& grid = level_.map().grid();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (no_entry_[grid.index(column, row)])
        narrow.push_back({column, row});
  narrow_ = areaUnder(narrow, std::numeric_limits<double>::infinity());
  return std::move(paths_);
}

void HighSpeedPlan::report(Report& figures) const
{
  const double cell = material_.grid().cell;
  figures.set("cut_mm", cut_);
  figures.set("linked_mm", linked_);
  figures.set("ramped_mm", ramped_);
  figures.set("ramped_slots_mm", slots_);
  figures.set("helices", helices_);
  figures.set("narrow_mm2", narrow_);
  figures.set("skin_mm2",
              static_cast<double>(material_.left()) * cell * cell - narrow_);
}

void HighSpeedPlan::begin()
{
  paths_.push_back({{}, false});
}

void HighSpeedPlan::add(const Vector2d& at, Motion motion)
{
  auto& points = paths_.back().points;
  const Vector3d p(at.x(), at.y(), level_.z());
  if (!points.empty()) {
    const double length = (p - points.back().at).norm();
    (motion == Motion::Link ? linked_ : cut_) += length;
    if (length == 0)
      return;
  }
  points.push_back({p, motion});
}

bool HighSpeedPlan::cutFrom(const Front& first,
                            const std::vector<Node>& way,
                            bool linked)
{
  const double r = walker_.limits().radius;
  Pose start{level_.map().at(first.at), 0};
  const Vector2d to = material_.middleToCut(start.at, r + 2 * level_.map().grid().cell);
  start.heading = headingOf(start.at, to) + settings_.side * M_PI / 2;
  const Walk walk = bestWalk(start);
  if (walk.area < ground_.crumb())
    return false;
  if (linked && tool_) {
    start.heading = headingOf(walk.points[0], walk.points[1]);
    const auto link = smoothLink(level_, ground_, *tool_, start, way, kLinkTurn * r);
    for (std::size_t i = 1; i < link.size(); ++i) {
      add(link[i], Motion::Link);
      material_.cut(link[i - 1], link[i], r);
    }
  }
  else {
    begin();
    add(start.at, Motion::Cut);
  }
  follow(walk);
  return true;
}

/// The walk that keeps a way out, or, where it gets nowhere, what takes more.
Walk HighSpeedPlan::bestWalk(const Pose& start)
{
  const double r = walker_.limits().radius;
  Walk best;
  for (const WayOut kind : {WayOut::Gentle, WayOut::Tight, WayOut::None}) {
    Walk walk = walker_.cutFrom(start, true, kind);
    material_.restore(walk.log, 0);
    if (walk.area > best.area)
      best = std::move(walk);
    if (best.area >= kFairArea * r * r)
      break;
  }
  return best;
}

void HighSpeedPlan::follow(const Walk& walk)
{
  const auto points = simplified(level_, walk.points, material_.grid().cell / 8);
  for (std::size_t i = 1; i < points.size(); ++i) {
    add(points[i], Motion::Cut);
    material_.cut(points[i - 1], points[i], walker_.limits().radius);
  }
  tool_ = Pose{points.back(), walk.heading};
}

void HighSpeedPlan::addEntry(const std::vector<Vector3d>& way)
{
  begin();
  auto& points = paths_.back().points;
  const double r = walker_.limits().radius;
  for (std::size_t i = 0; i < way.size(); ++i) {
    points.push_back({way[i], Motion::Ramp});
    if (i == 0)
      continue;
    ramped_ += (way[i] - way[i - 1]).norm();
    if (std::max(way[i].z(), way[i - 1].z()) <= level_.z())
      material_.cut(way[i - 1].head<2>(), way[i].head<2>(), r);
  }
  const std::size_t last = way.size() - 1;
  tool_ = Pose{way[last].head<2>(),
               headingOf(way[last - 1].head<2>(), way[last].head<2>())};
}

Descent HighSpeedPlan::descentOver(const std::vector<Vector2d>& track) const
{
  const CellGrid& grid = level_.map().grid();
  double top = level_.z();
  for (std::size_t i = 0; i < track.size(); ++i)
    forCapsule(grid,
               track[i > 0 ? i - 1 : 0],
               track[i],
               walker_.limits().radius + grid.cell,
               [&](int row, int first, int last) {
                 for (int column = first; column <= last; ++column)
                   top = std::max(top, level_.map().standing({column, row}));
               });
  return {std::min(top, level_.z() + settings_.layer), settings_.ramp_slope};
}

/// What is left to cut under the tool at these nodes; no more than about `enough`.
double HighSpeedPlan::areaUnder(const std::vector<Node>& nodes, double enough)
{
  const double cell = material_.grid().cell;
  const std::size_t before = material_.left();
  const auto area = [&] {
    return static_cast<double>(before - material_.left()) * cell * cell;
  };
  Material::Log log;
  for (std::size_t k = 0; k < nodes.size() && area() < enough; ++k) {
    const Vector2d p = level_.map().at(nodes[k]);
    material_.cut(p, p, ground_.frontRadius(), &log);
  }
  const double found = area();
  material_.restore(log, 0);
  return found;
}

/// Whether moving the tool along the way would cut what is to be cut.
bool HighSpeedPlan::wouldCut(const std::vector<Vector2d>& way)
{
  Material::Log log;
  const std::size_t before = material_.left();
  for (std::size_t i = 1; i < way.size() && material_.left() == before; ++i)
    material_.cut(way[i - 1], way[i], walker_.limits().radius, &log);
  const bool cuts = material_.left() < before;
  material_.restore(log, 0);
  return cuts;
}

/// The node nearest to the middle of those with so much room.
Node HighSpeedPlan::middleOf(const std::vector<Node>& nodes, double room) const
{
  const LevelMap& map = level_.map();
  std::vector<Node> wide;
  Vector2d sum(0, 0);
  for (const Node n : nodes)
    if (walker_.roomAt(map.at(n)) >= room) {
      wide.push_back(n);
      sum += map.at(n);
    }
  const Vector2d middle = sum / static_cast<double>(wide.size());
  return *std::min_element(wide.begin(), wide.end(), [&](Node a, Node b) {
    return (map.at(a) - middle).squaredNorm() < (map.at(b) - middle).squaredNorm();
  });
}

bool HighSpeedPlan::enter()
{
  // Places that no walk from clear ground gets to, a connected piece at a time: the
  // one with the widest spot first.
  const LevelMap& map = level_.map();
  const CellGrid& grid = map.grid();
  const double r = walker_.limits().radius;
  auto open = material_.nodesToCut(ground_.frontRadius());
  std::vector<Node> all;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Node n{column, row};
      const std::size_t i = map.index(n);
      open[i] = open[i] && level_.isFree(n) && !no_entry_[i];
      if (open[i])
        all.push_back(n);
    }
  while (!all.empty()) {
    double room = 0;
    for (const Node n : all)
      room = std::max(room, walker_.roomAt(map.at(n)));
    const Node widest = middleOf(all, room - grid.cell);
    const auto piece = takePiece(open, widest);
    if (areaUnder(piece, ground_.crumb()) >= ground_.crumb()) {
      if (room >= kLeastHelix * r && boreHelix(widest))
        return true;
      if (rampAlong(piece))
        return true;
    }
    else if (sweepUp(all)) {
      while (sweepUp(all))
        ;
      return true;
    }
    for (const Node n : piece)
      no_entry_[map.index(n)] = 1;
    all.erase(std::remove_if(all.begin(),
                             all.end(),
                             [&](Node n) { return no_entry_[map.index(n)] != 0; }),
              all.end());
  }
  return false;
}

/// The connected piece of `open` that `first` is in; it is closed.
std::vector<Node> HighSpeedPlan::takePiece(std::vector<unsigned char>& open,
                                           Node first) const
{
  const LevelMap& map = level_.map();
  std::vector<Node> piece{first};
  open[map.index(first)] = 0;
  for (std::size_t k = 0; k < piece.size(); ++k)
    for (int d = 0; d < 4; ++d) {
      const Node n = piece[k] + direction(d);
      if (map.has(n) && open[map.index(n)]) {
        open[map.index(n)] = 0;
        piece.push_back(n);
      }
    }
  return piece;
}

/// The nearest crumb that is not worth a walk: to it through next to nothing.
bool HighSpeedPlan::sweepUp(const std::vector<Node>& places)
{
  if (!tool_)
    return false;
  const double r = walker_.limits().radius, cell = material_.grid().cell;
  const auto most = static_cast<std::size_t>(ground_.crumb() / (cell * cell));
  std::vector<Node> left;
  for (const Node n : places)
    if (material_.toCut(level_.map().at(n), ground_.frontRadius(), 0) > 0)
      left.push_back(n);
  const auto way = ground_.brush(tool_->at, left, most);
  if (way.empty())
    return false;
  const auto pulled = tightened(way, [&](const Vector2d& a, const Vector2d& b) {
    return level_.isFree(a, b) && material_.standing(a, b, r, most) <= most;
  });
  const std::size_t before = material_.left();
  for (std::size_t i = 1; i < pulled.size(); ++i) {
    material_.cut(pulled[i - 1], pulled[i], r);
    add(pulled[i], Motion::Link);
  }
  if (pulled.size() > 1)
    tool_ = Pose{pulled.back(), headingOf(pulled[pulled.size() - 2], pulled.back())};
  return material_.left() < before;
}

/// Along the walls where a skin is left.
void HighSpeedPlan::skim()
{
  const LevelMap& map = level_.map();
  const double r = walker_.limits().radius;
  const auto cuts = material_.nodesToCut(
      r - std::max(kThinnest * map.grid().cell, material_.grid().cell));
  for (auto& loop : borderLoops(level_)) {
    if (settings_.side > 0) // their walls are on the left
      std::reverse(loop.begin(), loop.end());
    neededStretches(
        0,
        static_cast<int>(loop.size()),
        static_cast<int>(r / map.grid().cell),
        [&](int i) { return cuts[map.index(loop[i])] != 0; },
        [&](int first, int last) {
          std::vector<Vector2d> wall;
          for (int i = std::max(0, first - 1);
               i <= std::min(last + 1, static_cast<int>(loop.size()) - 1);
               ++i)
            wall.push_back(map.at(loop[i]));
          if (wall.size() > 1)
            skimAlong(wall);
        });
  }
}

bool HighSpeedPlan::skimAlong(const std::vector<Vector2d>& wall)
{
  const double r = walker_.limits().radius;
  const double cell2 = material_.grid().cell * material_.grid().cell;
  const auto way = tightened(
      wall, [&](const Vector2d& a, const Vector2d& b) { return level_.isFree(a, b); });
  const auto crumb = static_cast<std::size_t>(ground_.crumb() / cell2);
  Material::Log log;
  bool thin = material_.standing(way[0], way[0], r, crumb) <= crumb;
  for (std::size_t i = 1; i < way.size() && thin; ++i) {
    const double most = walker_.limits().width * (way[i] - way[i - 1]).norm();
    const auto taken = material_.cut(way[i - 1], way[i], r, &log);
    thin = static_cast<double>(taken) * cell2 <= most / 2 + ground_.crumb();
  }
  if (!thin) {
    material_.restore(log, 0);
    return false;
  }
  material_.restore(log, 0);
  const LevelMap& map = level_.map();
  const Node first{map.grid().columnOf(way[0].x()), map.grid().rowOf(way[0].y())};
  std::vector<Vector2d> link;
  if (tool_)
    link = ground_.brush(tool_->at, {first}, crumb);
  if (link.empty()) {
    begin();
    add(way[0], Motion::Cut);
  }
  else {
    link = tightened(link, [&](const Vector2d& a, const Vector2d& b) {
      return level_.isFree(a, b) && material_.standing(a, b, r, crumb) <= crumb;
    });
    for (std::size_t i = 1; i < link.size(); ++i) {
      material_.cut(link[i - 1], link[i], r);
      add(link[i], Motion::Link);
    }
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    material_.cut(way[i - 1], way[i], r);
    add(way[i], Motion::Cut);
  }
  tool_ = Pose{way.back(), headingOf(way[way.size() - 2], way.back())};
  return true;
}

bool HighSpeedPlan::boreHelix(Node centre)
{
  const Vector2d at = level_.map().at(centre);
  const double r = walker_.limits().radius;
  const double flat = level_.map().tool().flatRadius();
  const double radius = std::min(
      {walker_.roomAt(at), kMostHelix * r, std::max(kMostHelix * flat, r / 2)});
  const auto way =
      helix(level_,
            at,
            radius,
            settings_.side,
            descentOver({at - Vector2d(radius, 0), at + Vector2d(radius, 0)}));
  if (!way)
    return false;
  std::vector<Vector2d> turn;
  for (const auto& p : *way)
    turn.emplace_back(p.head<2>());
  if (!wouldCut(turn))
    return false;
  addEntry(*way);
  ++helices_;
  Walk walk = walker_.cutFrom(*tool_, false);
  material_.restore(walk.log, 0);
  if (walk.points.size() > 1)
    follow(walk);
  return true;
}

bool HighSpeedPlan::rampAlong(const std::vector<Node>& piece)
{
  // The longest of the shortest ways through the piece, about: from the node furthest
  // from any to the one furthest from that.
  const LevelMap& map = level_.map();
  constexpr std::size_t kOutside = 0, kUnseen = 1, kSeen = 2;
  std::vector<std::size_t> from(map.grid().size(), 0);
  std::vector<unsigned char> state(map.grid().size(), kOutside);
  const auto furthest = [&](Node start) {
    for (const Node n : piece)
      state[map.index(n)] = kUnseen;
    std::vector<Node> open{start};
    state[map.index(start)] = kSeen;
    from[map.index(start)] = map.index(start);
    for (std::size_t k = 0; k < open.size(); ++k)
      for (int d = 0; d < 4; ++d) {
        const Node n = open[k] + direction(d);
        if (!map.has(n) || state[map.index(n)] != kUnseen)
          continue;
        state[map.index(n)] = kSeen;
        from[map.index(n)] = map.index(open[k]);
        open.push_back(n);
      }
    return open.back();
  };
  const Node start = furthest(piece.front()), end = furthest(start);
  std::vector<Vector2d> track{map.at(end)};
  for (std::size_t i = map.index(end); i != map.index(start);) {
    i = from[i];
    track.push_back(map.at({int(i % map.grid().columns), int(i / map.grid().columns)}));
  }
  const auto pulled = tightened(
      track, [&](const Vector2d& a, const Vector2d& b) { return level_.isFree(a, b); });
  double length = 0;
  for (std::size_t i = 1; i < pulled.size(); ++i)
    length += (pulled[i] - pulled[i - 1]).norm();
  const double r = walker_.limits().radius;
  if (length < kShortestTrack * r)
    return false;
  if (!wouldCut(pulled))
    return false;
  addEntry(rampForthAndBack(pulled, level_.z(), descentOver(pulled)));
  slots_ += length;
  return true;
}

} // namespace pointmill
