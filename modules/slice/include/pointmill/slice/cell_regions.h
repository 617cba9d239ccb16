// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <cstddef>
#include <vector>

namespace pointmill {

/// @brief Calls visit(column, row, straight) for the eight neighbours of a cell that
/// the grid has; `straight` for those that share an edge with it.
template <typename Visit>
void forNeighbours(const CellGrid& grid, int column, int row, Visit&& visit)
{
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c)
      if ((c != column || r != row) && grid.has(c, r))
        visit(c, r, c == column || r == row);
}

/// @brief Which cells are connected.
enum class Connected {
  Edges,  ///< those that share an edge
  Corners ///< those that share a corner as well
};

/// @brief Adds to @p region all cells of @p mask (not 0) that are connected to its own;
/// all of them are taken out of the mask.
void takeRegion(const CellGrid& grid,
                std::vector<unsigned char>& mask,
                Connected connected,
                std::vector<std::size_t>& region);

/// @brief The connected regions of a mask, in the order of their first cells, each with
/// that cell first.
std::vector<std::vector<std::size_t>>
cellRegions(const CellGrid& grid, std::vector<unsigned char> mask, Connected connected);

} // namespace pointmill
