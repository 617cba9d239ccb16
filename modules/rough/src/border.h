// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <vector>

namespace pointmill {

/// @brief A walk along the border of the free nodes of one level: the tool stands on a
/// free node and has a node that is not free to its left.
struct BorderWalker {
  const Level& level;
  Node at;
  int wall; ///< direction of the node that is not free: 0 +X, 1 +Y, 2 -X, 3 -Y

  /// @brief One step on, keeping the wall to the left: round an island clockwise.
  void step();
};

/// @brief Unit step of a direction (0 +X, 1 +Y, 2 -X, 3 -Y).
Node direction(int d);

/// @brief All closed walks along the border between free and other nodes of a level.
std::vector<Chain> borderLoops(const Level& level);

} // namespace pointmill
