// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <string>

namespace pointmill {

/// @brief How a cloud is shown.
struct CloudView {
  bool window = true; ///< until it is closed
  std::string png;    ///< a picture of it; empty: none
  double point_size = 1.0;
  double axes = 0.0;                            ///< length of the axes [mm]; 0: none
  std::array<double, 3> background = {0, 0, 0}; ///< red, green, blue, 0 .. 1
};

/// @brief Shows @p cloud as `pcl_viewer` does, with its keys and mouse: 1 .. 9 colour
/// by the cloud's fields in turn, h lists all keys. A cloud of CL points is shown as
/// its passes as well, each level in a colour of its own, all rapids pale.
/// @throws DataError where the cloud has no x, y and z, no display is there, or
/// @p view.png cannot be written (nothing is left then)
void showCloud(const std::string& title,
               const pcl::PCLPointCloud2& cloud,
               const CloudView& view = {});

} // namespace pointmill
