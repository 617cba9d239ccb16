// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/finish/cl_surface.h>

namespace pointmill {
template class CLSurface<pcl::PointXYZ>;
template class CLSurface<pcl::PointXYZI>;
template class CLSurface<pcl::PointXYZRGB>;
template class CLSurface<pcl::PointXYZRGBA>;
template class CLSurface<pcl::PointNormal>;
} // namespace pointmill
