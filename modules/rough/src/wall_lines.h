// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "iso_lines.h"

#include <pointmill/rough/level.h>

#include <vector>

namespace pointmill {

/// @brief Along all walls of a level as near as the tool may get, not to a node's cell
/// but to a sixteenth of it: the wall is to the right, as climb milling wants it. Every
/// move between successive points is safe.
std::vector<IsoLine> wallLines(const Level& level);

/// @brief A line with fewer points, none further than @p tolerance [mm] from it, whose
/// moves are proven; as it was where they cannot be.
std::vector<Eigen::Vector2d>
simplified(const Level& level, std::vector<Eigen::Vector2d> line, double tolerance);

/// @brief The stretches of a line along which there is something to cut; those less
/// than @p gap [mm] apart are taken as one. A closed line is opened where there is not.
/// @param needed set for the nodes where there is
std::vector<IsoLine> neededStretches(const CellGrid& grid,
                                     const std::vector<unsigned char>& needed,
                                     const IsoLine& line,
                                     double gap);

} // namespace pointmill
