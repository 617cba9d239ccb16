// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "iso_lines.h"

#include <pointmill/rough/level.h>

#include <vector>

namespace pointmill {

/// @brief Along all walls of a level as near as the tool may get, not to a node's cell
/// but to a sixteenth of it: the wall is to the right, as climb milling wants it. Made
/// the same way on every level, so that no skin stays between a wall and the next one.
std::vector<IsoLine> wallLines(const Level& level);

/// @brief The same line with corners only where it turns, none of it further than
/// @p tolerance [mm] from where it was, and points a cell apart between these. Its
/// moves are proven; where they cannot be, it stays as it was.
IsoLine straightened(const Level& level, const IsoLine& line, double tolerance);

/// @brief Without the points that lie on straight runs.
std::vector<Eigen::Vector2d> corners(const std::vector<Eigen::Vector2d>& points);

/// @brief The stretches of a line along which there is something to cut; those less
/// than @p gap [mm] apart are taken as one. A closed line is opened where there is not.
std::vector<IsoLine>
neededStretches(const IsoLine& line,
                const std::function<bool(const Eigen::Vector2d&)>& needed,
                double gap);

/// @brief Whether any node of the square that @p p lies in is set.
bool isSetNear(const CellGrid& grid,
               const std::vector<unsigned char>& nodes,
               const Eigen::Vector2d& p);

} // namespace pointmill
