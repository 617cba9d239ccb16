// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stretches.h"

#include <pointmill/rough/zigzag_roughing.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// A stretch of one row: where the tool may be (free) and where it must go (needed).
struct Span {
  int row;
  int free_first, free_last;
  int first, last;
  bool done = false;
};

/// The spans of one row. Needed stretches less than `gap` nodes apart are cut as one.
void findSpans(const Level& level, int row, int gap, std::vector<Span>& spans)
{
  const int columns = level.map().grid().columns;
  for (int c = 0; c < columns;) {
    if (!level.isFree(Node{c, row})) {
      ++c;
      continue;
    }
    const int free_first = c;
    while (c < columns && level.isFree(Node{c, row}))
      ++c;
    const int free_last = c - 1;
    neededStretches(
        free_first,
        free_last + 1,
        gap,
        [&](int i) {
          return level.isNeeded(Node{i, row});
        },
        [&](int first, int last) {
          // one node more at each end, into the open where there is room
          spans.push_back({row,
                           free_first,
                           free_last,
                           std::max(free_first, first - 1),
                           std::min(free_last, last + 1)});
        });
  }
}

void walk(Chain& chain, Node to)
{
  while (chain.back() != to) {
    Node n = chain.back();
    if (n.column != to.column)
      n.column += n.column < to.column ? 1 : -1;
    else
      n.row += n.row < to.row ? 1 : -1;
    chain.push_back(n);
  }
}

/// The column nearest to `from` where the tool gets from span a to span b on the level,
/// or -1.
int crossing(const Level& level, const Span& a, const Span& b, int from)
{
  const int low = std::max(a.free_first, b.free_first);
  const int high = std::min(a.free_last, b.free_last);
  const auto open = [&](int column) {
    for (int row = std::min(a.row, b.row); row <= std::max(a.row, b.row); ++row)
      if (!level.isFree(Node{column, row}))
        return false;
    return true;
  };
  const int reach = std::max(std::abs(from - low), std::abs(from - high));
  for (int away = 0; away <= reach; ++away)
    for (const int column : {from - away, from + away})
      if (column >= low && column <= high && open(column))
        return column;
  return -1;
}

} // namespace

std::vector<LevelPath> ZigZagRoughing::clearLevel(const Level& level, Report&) const
{
  // Rows from one end of the grid to the other; the first and last pass beside the
  // stock far enough to leave none.
  const int step = level.stride();
  std::vector<Span> spans;
  std::vector<std::size_t> row_start;
  for (int row = 0; row < level.map().grid().rows; row += step) {
    row_start.push_back(spans.size());
    findSpans(level, row, step, spans);
  }
  row_start.push_back(spans.size());

  std::vector<Chain> chains;
  for (auto& start : spans) {
    if (start.done)
      continue;
    Chain chain;
    Span* span = &start;
    Node entry{start.first, start.row};
    if (!chains.empty()) { // begin at the end that is nearer to where the tool is
      const int at = chains.back().back().column;
      if (std::abs(at - start.last) < std::abs(at - start.first))
        entry.column = start.last;
    }
    chain.push_back(entry);
    while (span) {
      span->done = true;
      const bool forward = std::abs(chain.back().column - span->first) <=
                           std::abs(chain.back().column - span->last);
      walk(chain, {forward ? span->first : span->last, span->row});
      walk(chain, {forward ? span->last : span->first, span->row});
      Span* next = nullptr;
      int across = -1;
      const std::size_t line = static_cast<std::size_t>(span->row / step) + 1;
      for (std::size_t i = line + 1 < row_start.size() ? row_start[line] : spans.size();
           i < (line + 1 < row_start.size() ? row_start[line + 1] : spans.size());
           ++i) {
        if (spans[i].done)
          continue;
        const int column = crossing(level, *span, spans[i], chain.back().column);
        const auto detour = [&](int c) { return std::abs(c - chain.back().column); };
        if (column >= 0 && (!next || detour(column) < detour(across))) {
          next = &spans[i];
          across = column;
        }
      }
      if (next) {
        walk(chain, {across, span->row});
        walk(chain, {across, next->row});
      }
      span = next;
    }
    chains.push_back(std::move(chain));
  }
  std::vector<LevelPath> paths;
  for (const auto& chain : chains)
    paths.push_back(pathAlong(level, chain));
  return paths;
}

} // namespace pointmill
