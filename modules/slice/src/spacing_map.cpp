// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/spacing_map.h>

namespace pointmill {
template class SpacingMap<pcl::PointXYZ>;
template class SpacingMap<pcl::PointXYZI>;
template class SpacingMap<pcl::PointXYZRGB>;
template class SpacingMap<pcl::PointXYZRGBA>;
template class SpacingMap<pcl::PointNormal>;
} // namespace pointmill
