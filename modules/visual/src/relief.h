// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "grid.h"
#include "plan.h"
#include "shade.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pointmill::visual {

/// @brief Draws points, coloured by their height, or where there are none a field of
/// heights, lit from the upper left, on a plan.
/// @return how it is lit and coloured
Light drawRelief(Canvas& canvas,
                 const Plan& plan,
                 const pcl::PointCloud<pcl::PointXYZ>* points,
                 const Grid* field);

} // namespace pointmill::visual
