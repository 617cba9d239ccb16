// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pointmill {

/// @brief Adds a cloud as what it is by its fields: the CL points of a path, an
/// occupancy map (with its cells as points as well), or any other, whose fields are its
/// colours.
/// @throws DataError where it is empty, or has no x, y and z
void addCloud(ViewerScene& scene,
              const std::string& name,
              const pcl::PCLPointCloud2::Ptr& cloud);

/// @brief What suits a scene without a program: paths by their levels or passes, the
/// map at its middle level.
ViewerLook lookFor(const ViewerScene& scene);

} // namespace pointmill
