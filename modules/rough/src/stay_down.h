// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>
#include <pointmill/rough/material.h>

#include <vector>

namespace pointmill {

/// @brief Paths that follow one another are made one where the tool can stay down
/// between them: straight over, or along nodes, with its axis where it has been or
/// where there is no stock, by a way of at most @p most [mm].
/// @param paths level ones, in machining order; they are milled in @p material
std::vector<LevelPath> joinPaths(const Level& level,
                                 Material& material,
                                 std::vector<LevelPath> paths,
                                 double most);

} // namespace pointmill
