// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief A ramp that goes forth and back over the beginning of @p pass, starting
/// @p height above its first point and ending on it. It never goes below the pass, so
/// it is as clear of the part as the pass itself.
/// @param degrees steepest descent relative to the pass
/// @param shortest so much of the pass is used however steep it is, and from there on
/// no move that is steeper than 45 degrees [mm in XY]
/// @param longest at most this much of the pass is used [mm in XY]
/// @return empty where the pass is too short to ramp on
std::vector<Eigen::Vector3d> rampAlong(const std::vector<Eigen::Vector3d>& pass,
                                       double height,
                                       double degrees,
                                       double shortest,
                                       double longest);

} // namespace pointmill
