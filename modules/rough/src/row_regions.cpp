// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "row_regions.h"
#include "stretches.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Columns of two spans at which the tool can get across that lie within `low` ..
/// `high`: calls take(column).
template <typename Take>
void forCrossings(const Level& level, const RowSpan& a, const RowSpan& b, Take&& take)
{
  const int low = std::max(a.free_first, b.free_first);
  const int high = std::min(a.free_last, b.free_last);
  const int from = std::min(a.row, b.row), to = std::max(a.row, b.row);
  for (int column = low; column <= high; ++column) {
    bool open = true;
    for (int row = from + 1; open && row < to; ++row)
      open = level.isFree(Node{column, row});
    if (open)
      take(column);
  }
}

/// Whether the tool gets across where it must go anyway, on both rows or nearly so.
bool areNeighbours(const Level& level, const RowSpan& a, const RowSpan& b)
{
  const int slack = level.stride();
  const int low = std::max(a.first, b.first) - slack;
  const int high = std::min(a.last, b.last) + slack;
  bool found = false;
  if (low <= high)
    forCrossings(level, a, b, [&](int column) {
      found = found || (column >= low && column <= high);
    });
  return found;
}

void findSpans(const Level& level, int row, std::vector<RowSpan>& spans)
{
  const int columns = level.map().grid().columns;
  for (int c = 0; c < columns; ++c) {
    if (!level.isFree(Node{c, row}))
      continue;
    const int free_first = c;
    while (c < columns && level.isFree(Node{c, row}))
      ++c;
    const int free_last = c - 1;
    // Stretches less than a step-over apart are one; a node more at each end, into the
    // open where there is room.
    neededStretches(
        free_first,
        c,
        level.stride(),
        [&](int i) {
          return level.isNeeded(Node{i, row});
        },
        [&](int first, int last) {
          spans.push_back({row,
                           free_first,
                           free_last,
                           std::max(free_first, first - 1),
                           std::min(free_last, last + 1)});
        });
  }
}

} // namespace

std::vector<std::vector<RowSpan>> rowSpans(const Level& level)
{
  // Rows from one end of the grid to the other; the first and last pass beside the
  // stock far enough to leave none.
  std::vector<std::vector<RowSpan>> rows;
  for (int row = 0; row < level.map().grid().rows; row += level.stride()) {
    rows.emplace_back();
    findSpans(level, row, rows.back());
  }
  return rows;
}

std::vector<RowRegion> rowRegions(const Level& level,
                                  const std::vector<std::vector<RowSpan>>& rows)
{
  std::vector<RowRegion> regions;
  std::vector<std::size_t> last; // region of each span of the row before
  for (std::size_t r = 0; r < rows.size(); ++r) {
    constexpr std::size_t kNone = ~std::size_t{0}, kMany = kNone - 1;
    const std::size_t before = last.size();
    std::vector<std::size_t> above(before, kNone), below(rows[r].size(), kNone);
    for (std::size_t i = 0; i < before; ++i)
      for (std::size_t j = 0; j < rows[r].size(); ++j)
        if (areNeighbours(level, rows[r - 1][i], rows[r][j])) {
          above[i] = above[i] == kNone ? j : kMany;
          below[j] = below[j] == kNone ? i : kMany;
        }
    std::vector<std::size_t> mine;
    for (std::size_t j = 0; j < rows[r].size(); ++j) {
      const std::size_t i = below[j];
      if (i < kMany && above[i] == j) {
        mine.push_back(last[i]);
        regions[last[i]].push_back(rows[r][j]);
        continue;
      }
      mine.push_back(regions.size());
      regions.push_back({rows[r][j]});
    }
    last = mine;
  }
  return regions;
}

Chain across(
    const Level& level, const RowSpan& from, Node at, const RowSpan& to, Node end)
{
  if (level.isFree(level.map().at(at), level.map().at(end)) &&
      std::abs(at.column - end.column) <= level.stride())
    return {at, end};
  int best = -1, way = 0;
  forCrossings(level, from, to, [&](int column) {
    const int detour = std::abs(column - at.column) + std::abs(column - end.column);
    if (best < 0 || detour < way) {
      best = column;
      way = detour;
    }
  });
  if (best < 0)
    return {};
  return {at, {best, from.row}, {best, to.row}, end};
}

Chain zigzag(const Level& level, const RowRegion& region, bool right, double& between)
{
  Chain chain{region.front().end(right), region.front().end(!right)};
  between = 0;
  for (std::size_t i = 1; i < region.size(); ++i) {
    const Node at = chain.back();
    // The end that is nearer: of a row that is much longer it may be the other one.
    const int to_left = std::abs(at.column - region[i].first);
    const int to_right = std::abs(at.column - region[i].last);
    right = to_left == to_right ? !right : to_right < to_left;
    const Chain way = across(level, region[i - 1], at, region[i], region[i].end(right));
    for (std::size_t k = 1; k < way.size(); ++k) {
      between += (level.map().at(way[k]) - level.map().at(way[k - 1])).norm();
      chain.push_back(way[k]);
    }
    chain.push_back(region[i].end(!right));
  }
  return chain;
}

} // namespace pointmill
