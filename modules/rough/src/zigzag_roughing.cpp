// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "row_regions.h"
#include "stay_down.h"

#include <pointmill/common/tour.h>
#include <pointmill/rough/zigzag_roughing.h>

#include <algorithm>

namespace pointmill {
namespace {

/// Air between two nodes.
double airBetween(const Level& level, Node a, Node b)
{
  return airBetween(level, level.map().at(a), level.map().at(b));
}

/// The paper's order: row by row, to and fro, each span from its end to its other end.
double airRowByRow(const Level& level, const std::vector<std::vector<RowSpan>>& rows)
{
  double sum = 0;
  bool begun = false, left = false;
  Node at;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const RowSpan& span = left ? row[row.size() - 1 - i] : row[i];
      if (begun)
        sum += airBetween(level, at, span.end(left));
      at = span.end(!left);
      begun = true;
    }
    left = left != !row.empty();
  }
  return sum;
}

} // namespace

std::vector<LevelPath> ZigZagRoughing::clearLevel(const Level& level,
                                                  Report& figures) const
{
  const auto rows = rowSpans(level);
  const auto regions = rowRegions(level, rows);
  const auto air = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return airBetween(level, a, b);
  };

  std::vector<Chain> chains; // two of each region
  std::vector<double> between;
  std::vector<TourItem> items;
  double within = 0;
  for (const auto& region : regions) {
    items.emplace_back();
    for (const bool right : {false, true}) {
      between.push_back(0);
      chains.push_back(zigzag(level, region, right, between.back()));
      const Eigen::Vector2d in = level.map().at(chains.back().front());
      const Eigen::Vector2d out = level.map().at(chains.back().back());
      items.back().push_back({in, out});
      items.back().push_back({out, in});
    }
  }
  const Tour tour = shortTour(items, TourStart::Any, air);
  std::vector<LevelPath> paths;
  for (const TourStop& stop : tour.stops) {
    Chain& chain = chains[2 * stop.item + stop.way / 2];
    if (stop.way % 2)
      std::reverse(chain.begin(), chain.end());
    within += between[2 * stop.item + stop.way / 2];
    paths.push_back(pathAlong(level, chain));
  }
  figures.set("regions", static_cast<double>(regions.size()));
  figures.set("air_before_mm", airRowByRow(level, rows));
  figures.set("air_mm", within + tour.after);
  Material material(level, 1);
  return joinPaths(level, material, std::move(paths));
}

std::vector<LevelPath> ZigZagRoughing::clearRest(const Level& level,
                                                 Material& material) const
{
  Material before = material;
  return shortRest(level, before, LevelRoughing::clearRest(level, material));
}

} // namespace pointmill
