// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief Rectangular contours from the outside in; where one meets the part it follows
/// the part's border clockwise until it is back on the contour (paper 001, ii).
class SpiralRoughing : public LevelRoughing {
public:
  SpiralRoughing() : LevelRoughing("SpiralRoughing") {}

protected:
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;
};

} // namespace pointmill
