// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pointmill {

/// @brief How the tool goes down into material.
struct Descent {
  double top;   ///< height of the tip from which it descends [mm]
  double slope; ///< down per length of way
};

/// @brief A helix down to the level about @p centre and a full turn there, or nothing
/// where it is not proven free.
/// @param side +1: anticlockwise; -1: clockwise
std::optional<std::vector<Eigen::Vector3d>> helix(const Level& level,
                                                  const Eigen::Vector2d& centre,
                                                  double radius,
                                                  double side,
                                                  const Descent& descent);

/// @brief Forth and back along @p track down to the level, and over all of it there.
std::vector<Eigen::Vector3d> rampForthAndBack(const std::vector<Eigen::Vector2d>& track,
                                              double z,
                                              const Descent& descent);

} // namespace pointmill
