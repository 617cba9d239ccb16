// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "high_speed_walk.h"

namespace pointmill {

/// @brief The ways from one pose to another that turn, go straight and turn again, with
/// turns of @p radius [mm], as polylines from place to place; the shortest first
/// (Dubins 1957).
std::vector<std::vector<Eigen::Vector2d>>
turnsBetween(const Pose& from, const Pose& to, double radius);

} // namespace pointmill
