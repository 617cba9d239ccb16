// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "transitions.h"

#include <algorithm>
#include <limits>

namespace pointmill {

using Eigen::Vector3d;
using Kind = Transition::Kind;

namespace {

/// A link may cut so deep into stock that no pass has taken, under its axis [mm].
constexpr double kLinkDepth = 0.5;

} // namespace

Transitions::Transitions(const Surroundings& around,
                         const Entries& entries,
                         const Cutting& cutting,
                         double rapid_rate,
                         double stay_down,
                         bool low_rapids)
    : around_(around), entries_(entries), cutting_(cutting), rapid_rate_(rapid_rate),
      stay_down_(stay_down), low_rapids_(low_rapids)
{
}

double Transitions::rapidDown(const Entry& entry) const
{
  const Vector3d& to = entry.from();
  // Rapids mind every splinter that may stand at the rim.
  return std::max(around_.standing(to, around_.tool.radius()), to.z() - kNothing) +
         around_.approach;
}

bool Transitions::isAir(const Vector3d& at) const
{
  return around_.nominal &&
         around_.nominal->highest(at.x(), at.y(), around_.tool.radius()) <= at.z();
}

Transition Transitions::over(const Vector3d& from, const Entry& entry) const
{
  const Vector3d& to = entry.from();
  Transition quickest{Kind::Plane, around_.clearance, 0, entry};
  quickest.minutes = minutes(from, around_.clearance, Kind::Plane, entry);
  if (!around_.part || !around_.stock)
    return quickest;
  const double least = std::max(from.z(), rapidDown(entry));
  const auto consider = [&](Kind kind, double height) {
    height = std::max(height, least);
    if (height >= around_.clearance)
      return;
    const double takes = minutes(from, height, kind, entry);
    if (takes < quickest.minutes)
      quickest = {kind, height, takes, entry};
  };
  if (low_rapids_)
    consider(Kind::Rapid, around_.highestInBox(from, to) + around_.approach);
  consider(Kind::Lift,
           std::max(around_.lowestOver(from, to),
                    around_.standing(from, to, around_.tool.radius())) +
               around_.approach);
  return quickest;
}

Transition Transitions::best(const Vector3d& from,
                             const std::vector<Vector3d>& pass) const
{
  const Entry entry = entries_.into(pass);
  Transition quickest{
      Kind::Plane, around_.clearance, std::numeric_limits<double>::infinity(), entry};
  if (entry.kind != EntryKind::Impossible)
    quickest = over(from, entry);
  const double height = stayHeight(from, pass.front());
  if (height < around_.clearance) {
    const Entry linked = entries_.fromLink(pass, height);
    if (linked.kind != EntryKind::Impossible) {
      const double takes = minutes(from, height, Kind::Stay, linked);
      if (takes < quickest.minutes)
        quickest = {Kind::Stay, height, takes, linked};
    }
  }
  return quickest;
}

double Transitions::stayHeight(const Vector3d& from, const Vector3d& start) const
{
  if (!around_.part || (start - from).head<2>().norm() > stay_down_)
    return around_.clearance;
  const double higher = std::max(from.z(), start.z());
  const double z = std::max(around_.lowestOver(from, start), higher);
  // Over a hill, or through stock that no pass has taken, the way round is better. A
  // thin wall at the rim may be cut, as far as that is no more than a cut at full feed.
  const Tool& tool = around_.tool;
  const double d = tool.endDiameter();
  if (z > higher + stay_down_ || around_.standing(from, start, d / 6) > z + kLinkDepth)
    return around_.clearance;
  const Vector3d a(from.x(), from.y(), z), b(start.x(), start.y(), z);
  const double length = (b - a).norm();
  if (around_.cutOf({a, b}).volume > kMostSection * d * d * std::max(length, d / 4))
    return around_.clearance;
  return std::min(z, around_.clearance);
}

double Transitions::minutes(const Vector3d& from,
                            double height,
                            Kind kind,
                            const Entry& entry) const
{
  const Vector3d& to = entry.from();
  const double down = std::min(height, rapidDown(entry));
  const double across = (to - from).head<2>().norm();
  const bool rapid = kind == Kind::Plane || kind == Kind::Rapid;
  double sum =
      across / (rapid ? rapid_rate_ : cutting_.feed) +
      (height - from.z()) / (kind == Kind::Stay ? cutting_.feed : rapid_rate_) +
      (height - down) / rapid_rate_ +
      std::max(0.0, down - to.z()) / (isAir(to) ? cutting_.feed : cutting_.plunge_feed);
  Vector3d at = to;
  for (const auto& step : entry.steps) {
    if (step.to != at)
      sum += (step.to - at).norm() / feedOf(cutting_, at, step.to, step.motion);
    at = step.to;
  }
  return sum;
}

} // namespace pointmill
