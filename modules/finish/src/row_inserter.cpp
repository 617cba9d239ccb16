// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "row_inserter.h"

#include "scallop.h"

namespace pointmill {
namespace {

/// Scallops that exceed the limit by less are left: the step-over of a flat gives the
/// limit itself.
constexpr double kExceeds = 1.05;

} // namespace

Insertion RowInserter::between(const Row& low,
                               const Row& high,
                               const std::vector<Stretch>& stretches) const
{
  Insertion result;
  result.tally = ScallopTally(raster_.scallop);
  for (const Stretch& whole : stretches)
    for (const Stretch& s : rows_.within(0.5 * (low.v + high.v), whole))
      insert(low, high, s, 1.0, result);
  return result;
}

// The stretches that hold what is wanted. They overlap the ground beside them by a
// station; where they would end less than the tool's radius apart they are one.
std::vector<Stretch> RowInserter::parts(const std::vector<char>& wanted,
                                        Stretch whole) const
{
  const auto apart =
      static_cast<std::size_t>(raster_.tool.radius() / rows_.stations().step);
  std::vector<Stretch> found;
  for (std::size_t i = whole.first; i <= whole.last; ++i) {
    if (!wanted[i - whole.first])
      continue;
    const Stretch s{std::max(whole.first + 1, i) - 1, std::min(i + 1, whole.last)};
    if (!found.empty() && s.first <= found.back().last + apart)
      found.back().last = s.last;
    else
      found.push_back(s);
  }
  return found;
}

void RowInserter::insert(const Row& low,
                         const Row& high,
                         Stretch stretch,
                         double weight,
                         Insertion& result) const
{
  const Row middle = rows_.drop(0.5 * (low.v + high.v), stretch);
  const double step = rows_.stations().step;
  const double radius = raster_.tool.corner_radius;
  const auto found = cusps(low, middle, high, step);
  const auto heights = scallops(found, radius, step, noise_);
  const auto exceeds = [&](std::size_t i) {
    return heights[i - stretch.first] > kExceeds * raster_.scallop;
  };
  const auto settle = [&](std::size_t i) {
    if (!low[i].touches || !high[i].touches)
      return; // beside the part
    const double height = heights[i - stretch.first];
    if (exceeds(i))
      result.steep.push_back(
          {rows_.frame().xy(rows_.stations()[i], middle.v), height, weight});
    else
      result.tally.add(height, weight);
  };

  std::vector<Stretch> refined;
  if (high.v - middle.v >= raster_.min_step_over) {
    std::vector<char> wanted;
    for (std::size_t i = stretch.first; i <= stretch.last; ++i)
      wanted.push_back((low[i].touches || high[i].touches || middle[i].touches) &&
                       exceeds(i) && !found[i - stretch.first].isCliff(radius));
    refined = parts(wanted, stretch);
  }
  std::size_t next = stretch.first;
  for (const Stretch& s : refined) {
    for (; next < s.first; ++next)
      settle(next);
    result.kept_out += rows_.cut(middle, s, result.passes);
    insert(low, middle, s, weight / 2, result);
    insert(middle, high, s, weight / 2, result);
    next = s.last + 1;
  }
  for (; next <= stretch.last; ++next)
    settle(next);
}

} // namespace pointmill
