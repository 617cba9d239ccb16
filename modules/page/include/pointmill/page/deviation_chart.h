// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/page/html.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>

namespace pointmill {

/// @brief How many points are how far from the milled surface.
struct DeviationShares {
  std::size_t points = 0, cut = 0;             ///< all; those that a tool came to
  std::size_t below = 0, within = 0, over = 0; ///< cut too deep, in order, left over

  DeviationShares(const pcl::PointCloud<pcl::PointXYZI>& deviation, double tolerance);
};

/// @brief The distribution of the deviations as SVG: the share of the points in each
/// step of the scale of deviationRange(), on a logarithmic scale as a few points far
/// off matter, with the tolerance marked. The outermost bars hold all that is beyond.
Html deviationChart(const pcl::PointCloud<pcl::PointXYZI>& deviation, double tolerance);

} // namespace pointmill
