// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_map.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace pointmill {

/// @brief A border between nodes that are inside of something and nodes that are not:
/// inside is to the left. Its first point is not repeated where it is closed.
struct IsoLine {
  std::vector<Eigen::Vector2d> points;
  bool closed = false;
};

/// @brief All of these borders, by marching squares; open ones end at the grid's edge.
/// Where two nodes that are inside touch by a corner they are kept apart.
/// @param inside a value for each node, not 0 for inside
/// @param crossing where the line passes between a node inside and its neighbour
///        outside; called once for each such pair
std::vector<IsoLine>
isoLines(const CellGrid& grid,
         const std::vector<unsigned char>& inside,
         const std::function<Eigen::Vector2d(Node in, Node out)>& crossing);

} // namespace pointmill
