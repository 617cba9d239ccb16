// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pointmill::detail {

using Triangle = std::array<std::uint32_t, 3>;

/// @brief The faces' area, in the square of the points' unit.
double areaOf(const std::vector<Eigen::Vector3d>& points,
              const std::vector<Triangle>& faces);

/// @brief Places about area x @p density points evenly on the faces; the same ones for
/// the same @p seed.
///
/// In units of 1 / sqrt(density) the largest circle without a sample has the radius
/// 0.71 on a plane along two axes, at most 1 on an inclined one, whatever the
/// triangles, and up to 1.5 at its border.
std::vector<Eigen::Vector3d> sampleFaces(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<Triangle>& faces,
                                         double density,
                                         std::uint32_t seed);

} // namespace pointmill::detail
