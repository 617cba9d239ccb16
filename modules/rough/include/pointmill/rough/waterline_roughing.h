// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief On every level only along the part's walls, as near as the allowance lets the
/// tool: takes the skin that a larger tool left on steep walls down in steps, so that
/// no finishing pass meets it as high as the wall. Each wall is climb milled.
class WaterlineRoughing : public LevelRoughing {
public:
  WaterlineRoughing() : LevelRoughing("WaterlineRoughing") {}

protected:
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  /// @brief Nothing: what is not at a wall is not this strategy's work.
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;
};

} // namespace pointmill
