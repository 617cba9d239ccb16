// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "camera.h"
#include "frame.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pointmill::visual {

/// @brief Draws the points as a surface: each covers its share of the picture, and
/// depth and normals come out of the blended points, so that overhangs and walls need
/// no grid. Non-finite points are left out.
void drawPoints(Frame& frame,
                const Camera& camera,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                Surface surface);

} // namespace pointmill::visual
