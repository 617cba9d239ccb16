// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/finish/buffer_points.h>

namespace pointmill {
template class BufferPoints<pcl::PointXYZ>;
template class BufferPoints<pcl::PointXYZI>;
template class BufferPoints<pcl::PointXYZRGB>;
template class BufferPoints<pcl::PointXYZRGBA>;
template class BufferPoints<pcl::PointNormal>;
} // namespace pointmill
