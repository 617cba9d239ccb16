// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/occupancy_map.h>

namespace pointmill {
template class OccupancyMap<pcl::PointXYZ>;
template class OccupancyMap<pcl::PointXYZI>;
template class OccupancyMap<pcl::PointXYZRGB>;
template class OccupancyMap<pcl::PointXYZRGBA>;
template class OccupancyMap<pcl::PointNormal>;
} // namespace pointmill
