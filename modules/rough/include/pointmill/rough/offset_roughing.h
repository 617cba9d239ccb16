// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief Contour-parallel clearing: lines of equal distance from the walls of the
/// level, a step-over apart, from the farthest to the walls themselves; a pocket is
/// cleared from its middle, an island from outside. Where a level has no walls, lines
/// of equal distance from the stock's edge, from there inwards. Closed lines are climb
/// milled.
class OffsetRoughing : public LevelRoughing {
public:
  OffsetRoughing() : LevelRoughing("OffsetRoughing") {}

protected:
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
};

} // namespace pointmill
