// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "wall_lines.h"

#include <vector>

namespace pointmill {

/// @brief What lies at least so far from the walls, in one piece: its border lines, and
/// the piece nearer to the walls that it is part of.
struct OffsetArea {
  int parent = -1;
  double distance = 0;        ///< of its border from the walls [mm]
  double deepest = 0;         ///< of what is needed in it, from the walls [mm]
  std::vector<IsoLine> lines; ///< what is needed of them
};

/// @brief The areas that clear a level by lines of equal distance, a step-over apart;
/// parents come before their children, whose lines are to be milled first.
/// @param walls distance from the walls; else from where nothing is needed
std::vector<OffsetArea> offsetAreas(const Level& level, bool walls);

/// @brief Whether there is any place on the level where the tool may not be.
bool hasWalls(const Level& level);

} // namespace pointmill
