// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/point_index.h>

#include <vector>

namespace pointmill {

/// @brief The height [mm] over each point of the part that a perfect pass of a tool
/// leaves: one that rests everywhere on the part, but no lower than @p floor. Where a
/// point is reached to 0.01 mm the height is not searched any better.
std::vector<float> perfectHeights(const PointIndex& part,
                                  const Tool& tool,
                                  double floor,
                                  unsigned threads);

} // namespace pointmill
