// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

namespace pointmill {

/// @brief A place that roughing leaves as the tool does not get in there: too narrow
/// for it.
struct NarrowPlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< where it is widest; z: its ground
  double area = 0;                              ///< [mm2]
  double volume = 0; ///< left above the part and its allowance [mm3]
};

} // namespace pointmill
