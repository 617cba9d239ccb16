// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief Direction in XY in which a way begins; along X where it stays in its place.
inline Eigen::Vector2d directionOf(const std::vector<Eigen::Vector3d>& way)
{
  for (const auto& p : way) {
    const Eigen::Vector2d d = (p - way.front()).head<2>();
    if (d.norm() > 1e-6)
      return d.normalized();
  }
  return Eigen::Vector2d::UnitX();
}

} // namespace pointmill
