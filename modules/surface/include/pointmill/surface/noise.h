// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/point_index.h>

#include <cstdint>

namespace pointmill {

/// @brief How far the points of a scan scatter about the surface that they lie on.
struct Noise {
  double deviation = 0; ///< standard deviation along the surface's normal [mm]
  double radius = 0;    ///< median radius of the neighbourhoods it was seen in [mm]
};

/// @brief Measures the scatter about local quadrics (Patch) at a few thousand seeded
/// random points: the median of their standard deviations, so that edges, steps and
/// strays do not count as long as they are few.
///
/// Noise that neighbouring points share is not seen, and form that is finer than the
/// neighbourhoods is taken for noise.
/// @throws DataError where no neighbourhood determines a quadric
Noise measureNoise(const PointIndex& points, std::uint32_t seed = 1);

} // namespace pointmill
