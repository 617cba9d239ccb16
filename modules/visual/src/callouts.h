// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <Eigen/Core>

#include <vector>

namespace pointmill::visual {

/// @brief Finds a place for a badge near each of some points, so that badges cover
/// neither each other nor the points, as long as there is room.
/// @param points,room [px]
/// @param size of a badge [px]
/// @return the badges' middles, within @p room
std::vector<Eigen::Vector2f>
placeCallouts(const std::vector<Eigen::Vector2f>& points, const Rect& room, float size);

} // namespace pointmill::visual
