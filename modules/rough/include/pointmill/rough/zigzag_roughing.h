// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief Zig-zag rows along X, each row from part to part; a row is entered from its
/// neighbour wherever the tool can get across on the level (paper 001, i).
class ZigZagRoughing : public LevelRoughing {
public:
  ZigZagRoughing() : LevelRoughing("ZigZagRoughing") {}

protected:
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
};

} // namespace pointmill
