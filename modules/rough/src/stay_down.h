// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>
#include <pointmill/rough/material.h>

#include <vector>

namespace pointmill {

/// @brief Paths that follow one another are made one where the tool can stay down
/// between them: straight over, or along nodes, with its axis where it has been or
/// where there is no stock, by a way that costs no more than a retract.
/// @param paths level ones, in machining order; they are milled in @p material
std::vector<LevelPath>
joinPaths(const Level& level, Material& material, std::vector<LevelPath> paths);

/// @brief What a retract costs in way at feed: up, down and a ramp [mm].
double retractCost(const Level& level);

/// @brief The air between two places of a level [mm]: straight if that is proven free,
/// else over it all, which costs a retract more.
double
airBetween(const Level& level, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// @brief What is left, level paths that may be milled from either end, in an order
/// with little air, and joined.
std::vector<LevelPath>
shortRest(const Level& level, Material& material, const std::vector<LevelPath>& rest);

} // namespace pointmill
