// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "high_speed_walk.h"

#include <pointmill/slice/distance_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;

constexpr double kContact = 0.02; // of the radius; a narrower cut is air
constexpr double kMostAir = 1.0;  // of the radius; then the walk has lost its material
constexpr int kTrials = 5, kHalvings = 5;
constexpr double kNear = 0.05;   // a turn differs little from the last [rad]
constexpr double kFurther = 0.1; // or by so much more
constexpr double kFine = 0.013;

} // namespace

Vector2d Pose::ahead(double length) const
{
  return at + length * Vector2d(std::cos(heading), std::sin(heading));
}

Walker::Walker(const Level& level, Material& material, const WalkLimits& limits)
    : level_(level), material_(material), limits_(limits)
{
  const CellGrid& grid = level.map().grid();
  std::vector<unsigned char> wall(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      wall[grid.index(column, row)] = !level.isFree(Node{column, row});
  room_ = distanceField(wall, grid.columns, grid.rows);
  const double cell = material.grid().cell;
  most_ = static_cast<std::size_t>(limits.width * limits.step / (cell * cell));
}

double Walker::roomAt(const Vector2d& p) const
{
  const CellGrid& grid = level_.map().grid();
  const int column = grid.columnOf(p.x()), row = grid.rowOf(p.y());
  if (!grid.has(column, row))
    return 0;
  const int edge =
      std::min({column, row, grid.columns - 1 - column, grid.rows - 1 - row});
  const double room = std::min<double>(room_[grid.index(column, row)], edge + 1);
  return std::max(0.0, (room - 2) * grid.cell);
}

Pose Walker::turned(const Pose& from, double angle) const
{
  Pose pose{from.at, from.heading + limits_.side * angle};
  pose.at = pose.ahead(limits_.step);
  return pose;
}

/// Whether the tool can still turn away from the material by a quarter, so that it does
/// not run into a wall.
bool Walker::hasWayOut(const Pose& pose, WayOut kind) const
{
  if (kind == WayOut::None || roomAt(pose.at) > 1.5 * limits_.radius)
    return true;
  constexpr double kPiece = M_PI / 12;
  const int gentle = kind == WayOut::Gentle ? 2 : 0;
  Pose at = pose;
  for (int i = 0; i < 6; ++i) {
    const double radius = i < gentle ? limits_.radius : limits_.tightest;
    const double chord = 2 * radius * std::sin(kPiece / 2);
    const Vector2d from = at.at;
    at.heading += limits_.side * kPiece / 2;
    at.at = at.ahead(chord);
    at.heading += limits_.side * kPiece / 2;
    if (roomAt(from) <= chord && !level_.isFree(from, at.at))
      return false;
  }
  return true;
}

bool Walker::mayGo(const Pose& to, const Vector2d& from, WayOut way_out) const
{
  // Where the tool comes from nothing stands any more.
  return material_.standing(to.at, to.at, limits_.radius, most_) <= most_ &&
         (roomAt(from) > limits_.step || level_.isFree(from, to.at)) &&
         hasWayOut(to, way_out);
}

/// The turn nearest to `in` that may be gone.
Walker::Turn
Walker::bestTurn(const Pose& pose, double in, double out, WayOut way_out) const
{
  const auto good = [&](double angle) {
    return mayGo(turned(pose, angle), pose.at, way_out);
  };
  double bad = in;
  for (int i = 0; i <= kTrials; ++i) {
    double best = in + (out - in) * i / kTrials;
    if (!good(best)) {
      bad = best;
      continue;
    }
    for (int k = 0; i > 0 && k < kHalvings; ++k) {
      const double middle = (bad + best) / 2;
      (good(middle) ? best : bad) = middle;
    }
    return {best, true};
  }
  return {0, false};
}

/// The same where it is close to `guess`.
Walker::Turn Walker::nearTurn(
    const Pose& pose, double guess, double in, double out, WayOut way_out) const
{
  const auto good = [&](double angle) {
    return mayGo(turned(pose, angle), pose.at, way_out);
  };
  double bad = guess - kNear, best = guess + kNear;
  if (!good(std::min(best, out))) {
    bad = best, best += kFurther;
    if (best >= out || !good(best))
      return {0, false};
  }
  else if (good(std::max(bad, in))) {
    if (bad <= in)
      return {in, true};
    best = bad, bad -= kFurther;
    if (bad <= in || good(bad))
      return {0, false};
  }
  best = std::min(best, out), bad = std::max(bad, in);
  while (best - bad > kFine) {
    const double middle = (bad + best) / 2;
    (good(middle) ? best : bad) = middle;
  }
  return {best, true};
}

Walk Walker::cutFrom(const Pose& start, bool any_heading, WayOut way_out)
{
  const double cell2 = material_.grid().cell * material_.grid().cell;
  const double step = limits_.step;
  // Round a corner of the material the axis turns about that corner.
  const double widest =
      std::max(limits_.tightest, limits_.radius - limits_.width) / step;
  double in = -1 / widest, out = step / limits_.tightest;
  if (any_heading)
    in = -M_PI / 3, out = M_PI / 2;

  Walk walk;
  Pose pose = start;
  walk.points.push_back(pose.at);
  material_.cut(pose.at, pose.at, limits_.radius, &walk.log); // what it brushes there
  double air = 0, area = 0, last = in;
  struct Kept {
    std::size_t points, taken;
    double area, heading;
  } kept{1, walk.log.size(), 0.0, pose.heading};
  while (air <= kMostAir * limits_.radius) {
    Turn turn = nearTurn(pose, last, in, out, way_out);
    for (const WayOut kind : {WayOut::Gentle, WayOut::Tight, WayOut::None})
      if (!turn.possible && kind >= way_out)
        turn = bestTurn(pose, in, out, kind);
    if (!turn.possible)
      break;
    last = turn.angle;
    const Pose next = turned(pose, turn.angle);
    const std::size_t before = material_.left();
    material_.cut(pose.at, next.at, limits_.radius, &walk.log);
    const double gain = static_cast<double>(before - material_.left()) * cell2;
    area += gain;
    pose = next;
    walk.points.push_back(pose.at);
    in = -1 / widest, out = step / limits_.tightest;
    air += step;
    if (gain > kContact * limits_.radius * step) {
      air = 0;
      kept = {walk.points.size(), walk.log.size(), area, pose.heading};
    }
  }
  walk.points.resize(kept.points);
  material_.restore(walk.log, kept.taken);
  walk.area = kept.area;
  walk.heading = kept.heading;
  return walk;
}

} // namespace pointmill
