// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <vector>

namespace pointmill {

/// @brief A stretch of one row: columns where the tool may be and where it must go.
struct RowSpan {
  int row;
  int free_first, free_last;
  int first, last;

  Node end(bool right) const { return {right ? last : first, row}; }
};

/// @brief Spans of successive rows, one of each, that one zig-zag clears.
using RowRegion = std::vector<RowSpan>;

/// @brief The spans of every stride-th row, row by row, from left to right.
std::vector<std::vector<RowSpan>> rowSpans(const Level& level);

/// @brief The spans as regions: two of neighbouring rows are in the same one where the
/// tool gets across on the level and neither has another neighbour there
/// (boustrophedon cells, H. Choset, 2000).
std::vector<RowRegion> rowRegions(const Level& level,
                                  const std::vector<std::vector<RowSpan>>& rows);

/// @brief The way across from the end of one span to an end of the other, by the column
/// that is nearest; empty where there is none.
Chain across(
    const Level& level, const RowSpan& from, Node at, const RowSpan& to, Node end);

/// @brief The zig-zag through a region that begins with its first row, at the left or
/// the right end.
/// @param between set to the length of the ways between its rows [mm]
Chain zigzag(const Level& level, const RowRegion& region, bool right, double& between);

} // namespace pointmill
