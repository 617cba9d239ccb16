// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "clear_ground.h"
#include "high_speed_walk.h"

namespace pointmill {

/// @brief A smooth way over clear ground from one pose to another.
/// @param way nodes that lead there
/// @param radius of its turns, where there is room [mm]
std::vector<Eigen::Vector2d> smoothLink(const Level& level,
                                        const ClearGround& ground,
                                        const Pose& from,
                                        const Pose& to,
                                        const std::vector<Node>& way,
                                        double radius);

} // namespace pointmill
