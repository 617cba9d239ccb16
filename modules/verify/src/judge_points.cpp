// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"
#include "perfect_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// A point this far under a perfect pass of the last tool is out of its reach [mm]:
/// more than what noise lifts the tool off.
constexpr double kReach = 0.1;

Quantiles quantiles(std::vector<float>& values)
{
  Quantiles q;
  if (values.empty())
    return q;
  const auto at = [&](double share) {
    const auto k = std::min(values.size() - 1,
                            static_cast<std::size_t>(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(k), values.end());
    return double(values[k]);
  };
  q.p50 = at(0.50);
  q.p95 = at(0.95);
  q.p99 = at(0.99);
  q.max = *std::max_element(values.begin(), values.end());
  return q;
}

} // namespace

void judgePoints(const PointIndex& part,
                 const std::vector<SweptMove>& moves,
                 double tolerance,
                 double floor,
                 unsigned threads,
                 Verification& result)
{
  std::vector<float> height;
  const Gouges gouges = sweepPoints(part, moves, tolerance, threads, height);
  result.gouge = gouges.depth;
  result.gouge_at = gouges.at;
  result.gouge_line = gouges.line;
  result.gouged_points = gouges.count;
  result.points = part.size();

  const Tool* last = nullptr;
  for (const auto& m : moves)
    if (!m.rapid)
      last = m.tool;
  if (!last)
    return;
  const std::vector<float> perfect =
      perfectHeights(part, *last, std::max(part.min().z(), floor), threads);
  std::vector<float> left, off;
  for (std::size_t q = 0; q < part.size(); ++q) {
    const double z = part.point(q).z(), best = std::max<double>(z, perfect[q]);
    const bool touched = std::isfinite(height[q]), reachable = best - z <= kReach;
    result.untouched_points += !touched;
    result.unreachable_points += !reachable;
    // infinite where no tool comes by
    left.push_back(std::max(0.f, static_cast<float>(height[q] - best)));
    if (touched && reachable)
      off.push_back(static_cast<float>(height[q] - z));
  }
  result.points = part.size();
  result.residual = quantiles(left);
  result.deviation = quantiles(off);
}

} // namespace pointmill
