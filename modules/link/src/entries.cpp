// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "entries.h"

#include "direction.h"
#include "ramp.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector2d;
using Eigen::Vector3d;

double Entries::lead(const Vector3d& at, double radius) const
{
  return std::min(std::max(around_.standing(at, radius), at.z()) + kNothing,
                  around_.clearance);
}

Entry Entries::into(const std::vector<Vector3d>& pass) const
{
  const Vector3d& start = pass.front();
  const double top = around_.standing(start, around_.certainRadius());
  const double z = lead(start, around_.certainRadius());
  if (top <= start.z() + kNothing)
    return {EntryKind::Open,
            {{{start.x(), start.y(), z}, Motion::Plunge}, {start, Motion::Plunge}}};
  Entry entry = fromOutside(pass);
  if (entry.steps.empty())
    entry = onHelix(pass);
  if (entry.steps.empty())
    entry = downFrom(pass, z);
  return entry;
}

Entry Entries::fromLink(const std::vector<Vector3d>& pass, double z) const
{
  const Vector3d& start = pass.front();
  const double top = around_.standing(start, around_.certainRadius());
  if (std::max(start.z(), std::min(top, z)) <= start.z() + kNothing)
    return {
        EntryKind::Open,
        {{{start.x(), start.y(), std::min(z, start.z() + kNothing)}, Motion::Plunge},
         {start, Motion::Plunge}}};
  return downFrom(pass, std::min(z, lead(start, around_.certainRadius())));
}

Entry Entries::downFrom(const std::vector<Vector3d>& pass, double z) const
{
  const Vector3d& start = pass.front();
  Entry entry;
  entry.steps.push_back({{start.x(), start.y(), z}, Motion::Plunge});
  // As long as the flat's radius: then its middle, half as wide, is nowhere pressed
  // down all the way.
  const Tool& tool = around_.tool;
  const double flat = tool.flatRadius(), longest = 2 * tool.diameter;
  const auto ramp =
      rampAlong(pass, z - start.z(), ramp_angle_, flat > 0 ? flat : longest, longest);
  for (const auto& p : ramp)
    entry.steps.push_back({p, Motion::Ramp});
  if (!ramp.empty())
    entry.kind = EntryKind::Ramp;
  else if (flat > 0)
    return {};
  else {
    entry.kind = EntryKind::Plunge;
    entry.steps.push_back({start, Motion::Plunge});
  }
  return entry;
}

Entry Entries::fromOutside(const std::vector<Vector3d>& pass) const
{
  const Vector3d& start = pass.front();
  const Vector2d ahead = directionOf(pass);
  const Vector2d left(-ahead.y(), ahead.x());
  const double d = around_.tool.diameter, slant = std::sqrt(0.5);
  // In line with the pass first, then with less and less of its direction.
  const Vector2d ways[] = {
      -ahead, slant * (left - ahead), slant * (-left - ahead), left, -left};
  constexpr int steps = 6; // of a quarter of the diameter
  for (int i = 1; i <= steps; ++i)
    for (const auto& way : ways) {
      Vector3d place = start;
      place.head<2>() += i * d / 4 * way;
      if (!around_.isOpen(place) || !around_.isClear({place, start}))
        continue;
      return {
          EntryKind::Outside,
          {{{place.x(), place.y(), lead(place, around_.tool.radius())}, Motion::Plunge},
           {place, Motion::Plunge},
           {start, Motion::LeadIn}}};
    }
  return {};
}

double Entries::widestHelix() const
{
  const Tool& tool = around_.tool;
  const double widest = helix_radius_ * tool.endDiameter();
  // The end's disc must pass over the middle: no core stays.
  return tool.flatRadius() > 0 ? std::min(widest, 0.95 * tool.flatRadius()) : widest;
}

Entry Entries::onHelix(const std::vector<Vector3d>& pass) const
{
  if (!around_.part || helix_radius_ <= 0)
    return {};
  const Vector3d& start = pass.front();
  const Vector2d ahead = directionOf(pass);
  // How much of the pass the tool may come back on, from a helix further ahead: before
  // a start at a wall there is no room.
  const bool level = pass.size() > 1 && std::abs(pass[1].z() - start.z()) < 1e-6;
  const double straight = level ? (pass[1] - start).norm() : 0.0;
  for (const double share : {1.0, 0.75, 0.5})
    for (const int back : {0, 1, 2})
      for (const int turn : {1, -1}) {
        const double radius = share * widestHelix();
        if (back * radius > straight)
          continue;
        Vector3d end = start;
        end.head<2>() += back * radius * ahead;
        Entry entry =
            spiralDown(TangentCircle(end, back > 0 ? -ahead : ahead, radius, turn));
        if (entry.steps.empty())
          continue;
        if (back > 0)
          entry.steps.push_back({start, Motion::LeadIn});
        return entry;
      }
  return {};
}

Entry Entries::spiralDown(const TangentCircle& circle) const
{
  constexpr int sides = TangentCircle::kSides;
  // What stands opposite to the end is most likely in the way.
  if (!around_.isClear({circle.before(sides / 2), circle.before(sides / 2)}))
    return {};
  std::vector<Vector3d> turn;
  for (int i = sides; i >= 0; --i)
    turn.push_back(circle.before(i));
  if (!around_.isClear(turn))
    return {};
  const double radius = circle.arm.norm();
  const Vector3d middle(circle.centre.x(), circle.centre.y(), circle.end.z());
  const double height = lead(middle, radius + around_.certainRadius()) - circle.end.z();
  const double side = 2 * radius * std::sin(M_PI / sides);
  const int down =
      static_cast<int>(std::ceil(height / (side * std::tan(ramp_angle_ * M_PI / 180))));
  Entry entry{EntryKind::Helix, {}};
  for (int i = down + sides; i >= 0; --i) { // a level turn at last: no wedge stays
    Vector3d at = circle.before(i);
    at.z() += height * std::max(0, i - sides) / down;
    entry.steps.push_back({at, entry.steps.empty() ? Motion::Plunge : Motion::Ramp});
  }
  return entry;
}

} // namespace pointmill
