// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/z_alignment.h>

namespace pointmill {
template class ZAlignment<pcl::PointXYZ>;
template class ZAlignment<pcl::PointXYZI>;
template class ZAlignment<pcl::PointXYZRGB>;
template class ZAlignment<pcl::PointXYZRGBA>;
template class ZAlignment<pcl::PointNormal>;
} // namespace pointmill
