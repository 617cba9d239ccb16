// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "border.h"

namespace pointmill {

Node direction(int d)
{
  constexpr int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};
  return {dx[d & 3], dy[d & 3]};
}

void BorderWalker::step()
{
  const int forward = (wall + 3) & 3; // the wall is to the left of the way ahead
  const Node ahead = at + direction(forward);
  const Node corner = ahead + direction(wall);
  if (!level.isFree(ahead))
    wall = forward; // an inner corner: turn right on the spot
  else if (!level.isFree(corner))
    at = ahead;
  else { // an outer corner: round it, left
    at = corner;
    wall = (forward + 2) & 3;
  }
}

std::vector<Chain> borderLoops(const Level& level)
{
  const CellGrid& grid = level.map().grid();
  std::vector<unsigned char> seen(grid.size(), 0); // one bit per direction of the wall
  std::vector<Chain> loops;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Node node{column, row};
      if (!level.isFree(node))
        continue;
      for (int d = 0; d < 4; ++d) {
        const Node beyond = node + direction(d);
        if (!level.map().has(beyond) || level.isFree(beyond) ||
            (seen[grid.index(column, row)] >> d & 1))
          continue;
        Chain loop;
        BorderWalker walker{level, node, d};
        for (;;) {
          unsigned char& bits = seen[grid.index(walker.at.column, walker.at.row)];
          if (bits >> walker.wall & 1)
            break;
          bits |= static_cast<unsigned char>(1 << walker.wall);
          if (loop.empty() || loop.back() != walker.at)
            loop.push_back(walker.at);
          walker.step();
        }
        if (loop.size() > 1 && loop.front() != loop.back())
          loop.push_back(loop.front());
        loops.push_back(loop);
      }
    }
  return loops;
}

} // namespace pointmill
