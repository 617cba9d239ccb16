// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

namespace pointmill {
namespace align {

/// @brief The rotation that turns @p axis (any length but zero) to +Z by the shortest
/// way. It depends smoothly on the axis also near -Z, so that noise cannot spin a part
/// that lies on its face: there it is half a turn about X and then the shortest way.
Eigen::Matrix3d rotationToZ(const Eigen::Vector3d& axis);

/// @brief @p rotation without its rounding errors: the third row keeps its direction,
/// the others are made orthogonal to it, and the determinant is +1.
Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& rotation);

} // namespace align
} // namespace pointmill
