// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stretches.h"

#include <pointmill/common/watch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// Moves of a stretch at most; they stray as far at most, in parts of the radius: far
/// less than a tile is wide.
constexpr std::uint32_t kMost = 8;
constexpr double kStray = 0.01;

} // namespace

Stretches::Stretches(const std::vector<SweptMove>& moves) : moves_(moves)
{
  cutter_.reserve(moves.size());
  for (const auto& m : moves) {
    auto known = cutters_.find(m.tool);
    if (known == cutters_.end())
      known = cutters_.emplace(m.tool, *m.tool).first;
    cutter_.push_back(&known->second);
  }

  // The stretch of the moves first .. last, each matched by its share of the way.
  const auto stretchOf = [&](std::uint32_t first, std::uint32_t last) {
    MoveStretch s{moves[first].a, moves[last].b, cutter_[first], first, last + 1, 0, 0};
    double length = 0, way = 0;
    for (std::uint32_t k = first; k <= last; ++k)
      length += (moves[k].b - moves[k].a).norm();
    for (std::uint32_t k = first; k < last; ++k) {
      way += (moves[k].b - moves[k].a).norm();
      const double share = length > 0 ? way / length : 0.0;
      const Eigen::Vector3d off = moves[k].b - (s.a + share * (s.b - s.a));
      s.aside = std::max(s.aside, off.head<2>().norm());
      s.over = std::max(s.over, std::abs(off.z()));
    }
    return s;
  };
  for (std::uint32_t k = 0; k < moves.size(); ++k) {
    checkInterrupted();
    if (!stretches_.empty()) {
      const MoveStretch& open = stretches_.back();
      if (open.last - open.first < kMost && moves[k].tool == moves[k - 1].tool &&
          moves[k].a == moves[k - 1].b) {
        const MoveStretch longer = stretchOf(open.first, k);
        if (std::max(longer.aside, longer.over) <= kStray * longer.cutter->radius()) {
          stretches_.back() = longer;
          continue;
        }
      }
    }
    stretches_.push_back(stretchOf(k, k));
  }
}

double Stretches::thinnest() const
{
  double thinnest = std::numeric_limits<double>::infinity();
  for (const auto& [tool, cutter] : cutters_)
    thinnest = std::min(thinnest, cutter.radius());
  return thinnest;
}

HeightRange Stretches::range(std::size_t i, double x, double y, double radius) const
{
  const MoveStretch& s = stretches_[i];
  HeightRange h =
      sweptHeightRange(s.cutter->profile(), s.a, s.b, x, y, radius + s.aside);
  h.low -= s.over;
  h.high += s.over;
  return h;
}

} // namespace pointmill
