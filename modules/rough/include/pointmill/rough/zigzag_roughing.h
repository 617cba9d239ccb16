// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief Zig-zag rows along X with minimum air time (paper 001, i). Rows stop at the
/// part; their spans are grouped into regions that one zig-zag clears, and the order of
/// the regions and the corner that each is entered at are the shortest tour that is
/// found. The tool stays down between regions where it can go over what is cut.
///
/// Report: "regions", and "air_before_mm" and "air_mm", the way between the ends of
/// spans row by row and as they go [mm]; a way that is not free on the level counts six
/// diameters more. Summed up over the levels.
class ZigZagRoughing : public LevelRoughing {
public:
  ZigZagRoughing() : LevelRoughing("ZigZagRoughing") {}

protected:
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;
};

} // namespace pointmill
