// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_map.h>

#include <limits>
#include <vector>

namespace pointmill {

/// @brief Height of one level, and the height of the one that what is free there too
/// is left to.
struct Plane {
  double z;
  double below = -std::numeric_limits<double>::infinity();
};

/// @brief Levels a step-down apart from @p top down to @p floor, and between two of
/// them one at the largest level ground that the tool stands on there, where that has
/// @p min_flat [mm2] at least (0: none).
std::vector<Plane> planesOf(
    const LevelMap& map, double floor, double top, double step_down, double min_flat);

} // namespace pointmill
