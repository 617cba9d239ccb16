// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "lead_arcs.h"

#include "direction.h"
#include "steps.h"
#include "tangent_circle.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using Eigen::Vector3d;
using Way = std::vector<Vector3d>;

/// The first moves of a way, cut off at @p length; empty unless they are level.
Way beginning(const Way& way, double length)
{
  Way first{way.front()};
  for (std::size_t i = 1; i < way.size() && length > 0; ++i) {
    const Vector3d move = way[i] - way[i - 1];
    if (std::abs(move.z()) > 1e-6)
      break;
    const double share = std::min(1.0, length / std::max(move.norm(), 1e-9));
    first.push_back(way[i - 1] + share * move);
    length -= move.norm();
  }
  return first.size() > 1 ? first : Way();
}

} // namespace

LeadArcs::Load LeadArcs::loadOf(const Way& way) const
{
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i)
    length += (way[i] - way[i - 1]).norm();
  const Cut cut = around_.cutOf(way);
  return {length > 0 ? cut.volume / length : 0.0, cut.depth};
}

Way LeadArcs::best(const Way& onwards, const Load& most, bool open) const
{
  Way found;
  double least = most.section;
  for (const int turn : {1, -1}) {
    const TangentCircle circle(onwards.front(), directionOf(onwards), radius_, turn);
    Way arc;
    for (int i = TangentCircle::kSides / 4; i >= 0; --i)
      arc.push_back(circle.before(i));
    if ((open && !around_.isOpen(arc.front())) || !around_.isClear(arc))
      continue;
    const Load takes = loadOf(arc);
    if (takes.depth <= most.depth && takes.section <= least &&
        (found.empty() || takes.section < least)) {
      found = arc;
      least = takes.section;
    }
  }
  return found;
}

Way LeadArcs::into(const Way& pass) const
{
  const Way first = beginning(pass, radius_ * M_PI / 2);
  if (radius_ <= 0 || first.empty())
    return {};
  const double d = around_.tool.endDiameter();
  // No thicker layer, be it a skin that stands beside the pass.
  const Load load = loadOf(first);
  return best(
      first, {std::max(kSkin * d * d, load.section), load.depth + kNothing}, true);
}

Way LeadArcs::outOf(const Way& pass) const
{
  const Way back = beginning({pass.rbegin(), pass.rend()}, radius_ * M_PI / 2);
  if (radius_ <= 0 || back.empty())
    return {};
  const double d = around_.tool.endDiameter();
  Way arc = best(back, {kSkin * d * d, kSkinHeight * d}, false);
  std::reverse(arc.begin(), arc.end());
  return arc;
}

} // namespace pointmill
