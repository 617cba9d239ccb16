// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "high_speed_link.h"

#include "dubins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Way = std::vector<Vector2d>;

double lengthOf(const Way& way)
{
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i)
    length += (way[i] - way[i - 1]).norm();
  return length;
}

bool isClear(const ClearGround& ground, const Way& way)
{
  for (std::size_t i = 1; i < way.size(); ++i)
    if (!ground.isClear(way[i - 1], way[i]))
      return false;
  return true;
}

/// The way without the corners that a straight move can leave out.
Way pulled(const ClearGround& ground, const Way& way)
{
  Way tight{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    // As far as can be seen: further and further, then halving.
    std::size_t next = i + 1, hidden = way.size();
    for (std::size_t step = 2; i + step < way.size(); step *= 2) {
      if (!ground.isClear(way[i], way[i + step])) {
        hidden = i + step;
        break;
      }
      next = i + step;
    }
    while (hidden - next > 1) {
      const std::size_t middle = next + (hidden - next) / 2;
      (ground.isClear(way[i], way[middle]) ? next : hidden) = middle;
    }
    tight.push_back(way[next]);
    i = next;
  }
  return tight;
}

/// The shortest way with turns of `radius` or, failing that, tighter ones.
std::optional<Way> turning(const ClearGround& ground,
                           const Pose& from,
                           const Pose& to,
                           double radius,
                           double longest)
{
  for (const double r : {radius, radius / 2, radius / 4})
    for (auto& way : turnsBetween(from, to, r))
      if (lengthOf(way) <= longest + 2 * M_PI * r && isClear(ground, way))
        return std::move(way);
  return {};
}

double headingOf(const Vector2d& a, const Vector2d& b)
{
  return std::atan2(b.y() - a.y(), b.x() - a.x());
}

} // namespace

Way smoothLink(const Level& level,
               const ClearGround& ground,
               const Pose& from,
               const Pose& to,
               const std::vector<Node>& nodes,
               double radius)
{
  Way way{from.at};
  for (const Node n : nodes)
    way.push_back(level.map().at(n));
  if (way.back() != to.at)
    way.push_back(to.at);
  way = pulled(ground, way);
  if (way.size() < 2)
    way.push_back(to.at);
  const double straight = lengthOf(way);
  if (auto direct = turning(ground, from, to, radius, 1.2 * straight))
    return *direct;

  // From the middle of one straight to the middle of the next.
  Way smooth{from.at};
  Pose at = from;
  const auto go = [&](const Pose& next, const Vector2d& corner) {
    const double short_way = (corner - at.at).norm() + (next.at - corner).norm();
    auto turn = turning(ground, at, next, radius, 1.2 * short_way);
    if (!turn)
      turn = Way{at.at, corner, next.at};
    smooth.insert(smooth.end(), turn->begin() + 1, turn->end());
    at = next;
  };
  for (std::size_t i = 1; i < way.size(); ++i)
    go({(way[i - 1] + way[i]) / 2, headingOf(way[i - 1], way[i])}, way[i - 1]);
  go(to, way.back());
  return smooth;
}

} // namespace pointmill
