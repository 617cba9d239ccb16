// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "iso_lines.h"

#include <array>
#include <tuple>
#include <unordered_map>

namespace pointmill {
namespace {

/// A side between a node and its neighbour: 2 * node, + 1 for the one above.
using Side = std::size_t;

/// The sides of a square, anticlockwise from its lower one, and their ends.
struct Square {
  std::array<Node, 4> corner; // anticlockwise from the lower left
  std::array<Side, 4> side;
};

Square squareAt(const CellGrid& grid, int column, int row)
{
  const auto at = [&](int c, int r) { return grid.index(c, r); };
  return {{Node{column, row},
           Node{column + 1, row},
           Node{column + 1, row + 1},
           Node{column, row + 1}},
          {2 * at(column, row),
           2 * at(column + 1, row) + 1,
           2 * at(column, row + 1),
           2 * at(column, row) + 1}};
}

} // namespace

std::vector<IsoLine>
isoLines(const CellGrid& grid,
         const std::vector<unsigned char>& inside,
         const std::function<Eigen::Vector2d(Node, Node)>& crossing)
{
  // From where the line enters a square to where it leaves it, inside to the left.
  std::unordered_map<Side, Side> next;
  std::unordered_map<Side, Eigen::Vector2d> place;
  std::unordered_map<Side, bool> entered;
  std::vector<Side> sides; // in the order of the squares
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const std::size_t low = grid.index(column, row), high = low + grid.columns;
      const int count = (inside[low] != 0) + (inside[low + 1] != 0) +
                        (inside[high] != 0) + (inside[high + 1] != 0);
      if (count == 0 || count == 4)
        continue;
      const Square square = squareAt(grid, column, row);
      std::array<bool, 4> in;
      for (int k = 0; k < 4; ++k)
        in[k] = inside[grid.index(square.corner[k].column, square.corner[k].row)] != 0;
      // A stretch of corners that are inside, anticlockwise: the line comes in behind
      // its last one and leaves before its first.
      for (int first = 0; first < 4; ++first) {
        if (!in[first] || in[(first + 3) & 3])
          continue;
        int last = first;
        while (in[(last + 1) & 3])
          last = (last + 1) & 3;
        const Side from = square.side[last], to = square.side[(first + 3) & 3];
        next[from] = to;
        entered[to] = true;
        for (const auto& [side, a, b] :
             {std::tuple(from, square.corner[last], square.corner[(last + 1) & 3]),
              std::tuple(to, square.corner[first], square.corner[(first + 3) & 3])})
          if (place.emplace(side, Eigen::Vector2d::Zero()).second) {
            place[side] = crossing(a, b);
            sides.push_back(side);
          }
      }
    }

  std::vector<IsoLine> lines;
  const auto follow = [&](Side from) {
    IsoLine line;
    for (Side at = from;;) {
      line.points.push_back(place[at]);
      const auto on = next.find(at);
      if (on == next.end())
        break;
      const Side to = on->second;
      next.erase(on);
      if (to == from) {
        line.closed = true;
        break;
      }
      at = to;
    }
    lines.push_back(std::move(line));
  };
  for (const Side side : sides) // open ones from where they begin
    if (!entered.count(side) && next.count(side))
      follow(side);
  for (const Side side : sides)
    if (next.count(side))
      follow(side);
  return lines;
}

} // namespace pointmill
