// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

namespace pointmill {

/// @brief A lower bound [mm] of sweptHeight() over all places within @p radius of
/// (x, y): the lowest tip from which the cutter gets there, and the least height of its
/// surface there. Infinite only where the cutter passes over none of them.
double sweptHeightBound(const CutterProfile& cutter,
                        const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b,
                        double x,
                        double y,
                        double radius);
inline double sweptHeightBound(const Tool& tool,
                               const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b,
                               double x,
                               double y,
                               double radius)
{
  return sweptHeightBound(tool.profile(), a, b, x, y, radius);
}

} // namespace pointmill
