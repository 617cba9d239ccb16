// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <vector>

namespace pointmill {

/// @brief A path and the number of its level, from the top.
struct RoughPass {
  LevelPath path;
  std::size_t level;
};

/// @brief The order in which regions that have no stock in common are each finished
/// from top to bottom, so that the tool stays where it is.
/// @param regions the map's
std::vector<std::size_t> byRegion(const LevelMap& map,
                                  const std::vector<int>& regions,
                                  const std::vector<RoughPass>& passes);

} // namespace pointmill
