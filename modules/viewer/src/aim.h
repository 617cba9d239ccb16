// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>

#include <Eigen/Geometry>

#include <vtkRenderer.h>

namespace pointmill::viewer {

/// @brief Turns the camera of @p renderer to a side of @p box, which fills the view, or
/// what legend and figures leave of it. Only the view from the corner has perspective.
void lookFrom(ViewedFrom from,
              const Eigen::AlignedBox3d& box,
              bool beside_texts,
              vtkRenderer* renderer);

/// @brief Goes to @p distance [mm] of a place, in the direction it looks in already.
void lookAt(const Eigen::Vector3d& place, double distance, vtkRenderer* renderer);

} // namespace pointmill::viewer
