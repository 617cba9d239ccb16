// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "path_colours.h"

#include <pointmill/viewer/viewer_scene.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>

namespace pointmill::viewer {

/// @brief Which CL points are shown, by what the tool did to arrive there.
using PathFilter = std::function<bool(const PointCL&, std::size_t operation)>;

/// @brief The feed moves of a path as line strips with a colour for each point, a strip
/// for each pass.
/// @param coarse strips leave out points nearer than this to the one before [mm]; 0:
/// all
vtkSmartPointer<vtkPolyData> feedLines(const ViewerScene& scene,
                                       const PathColours& colours,
                                       const PathFilter& shown,
                                       double coarse);

/// @brief The rapids as dashes of @p dash [mm], which OpenGL has no pattern for.
vtkSmartPointer<vtkPolyData>
rapidDashes(const ViewerScene& scene, const PathFilter& shown, double dash);

} // namespace pointmill::viewer
