// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "camera.h"
#include "frame.h"

namespace pointmill::visual {

/// @brief How a frame is lit and coloured.
struct Light {
  double low = 0.0, high = 1.0; ///< heights of the first and last colour [mm]
  bool more_below = false, more_above = false; ///< some lie far beyond these
  double reach = 1.0; ///< how far a wall darkens what lies beside it [mm]
};

/// @brief Lights the frame from the upper left, darkens corners and crevices, and draws
/// its edges.
Raster shade(const Frame& frame, const Camera& camera, const Light& light);

} // namespace pointmill::visual
