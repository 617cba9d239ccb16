// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <limits>

namespace pointmill {

/// @brief Bounds of heights [mm].
struct HeightRange {
  double low = std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// @brief Bounds of sweptHeight() over all places within @p radius of (x, y). Low is
/// the lowest tip from which the tool gets there and the least height of its surface
/// there, high what the tool leaves when it stands nearest. Low is infinite only where
/// the tool passes over none of the places, high wherever it may not pass over all of
/// them.
HeightRange sweptHeightRange(const CutterProfile& cutter,
                             const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b,
                             double x,
                             double y,
                             double radius);
inline HeightRange sweptHeightRange(const Tool& tool,
                                    const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b,
                                    double x,
                                    double y,
                                    double radius)
{
  return sweptHeightRange(tool.profile(), a, b, x, y, radius);
}

} // namespace pointmill
