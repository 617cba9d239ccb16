// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer_scene.h>

#include <vector>

namespace pointmill::viewer {

/// @brief Heights of the levels of a scene's roughing, from the top [mm]; of a map
/// alone a twentieth of its height each.
std::vector<double> levelsOf(const ViewerScene& scene);

} // namespace pointmill::viewer
