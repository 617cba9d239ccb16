// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

namespace pointmill {

/// @brief The block of raw material, an axis-aligned box in the part frame [mm].
struct Stock {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();

  double top() const { return max.z(); }
};

} // namespace pointmill
