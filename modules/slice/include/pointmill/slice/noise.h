// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>

namespace pointmill {

/// @brief How far the points of a scan scatter about the surface that they lie on.
struct Noise {
  double deviation = 0;    ///< standard deviation along the surface's normal [mm]
  double scatter = 0;      ///< the same with form too fine for the neighbourhoods [mm]
  double radius = 0;       ///< median radius of the neighbourhoods [mm]
  int neighbours = 0;      ///< points of each
  std::size_t samples = 0; ///< neighbourhoods
};

/// @brief Measures the scatter about local surfaces of the second degree.
///
/// At a few thousand seeded random points a quadric over the tangent plane is fitted to
/// the nearest points in space, so that steep, closed and folded scans are as good as
/// level ones. Each gives a variance, the squares over the degrees of freedom that are
/// left; their median, corrected for the skew of the chi-square distribution, is not
/// moved by edges, steps and strays as long as they are few. The neighbourhoods grow
/// until they are six deviations wide, since within a ball that is no larger than the
/// noise there is no surface to be seen.
///
/// Noise is the same in neighbourhoods of any size; form that a quadric cannot follow
/// grows as a power of theirs. Where twice as many neighbours scatter much more, the
/// power is taken from 1, 2 and 4 times as many, and what it leaves at size 0 is the
/// noise (Aitken's extrapolation): 0 where form explains all, as on bare terrain.
/// Noise that neighbouring points share is seen in part only.
/// @throws DataError for fewer than 8 different finite points
Noise measureNoise(const pcl::PointCloud<pcl::PointXYZ>& cloud, std::uint32_t seed = 1);

} // namespace pointmill
