// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer_scene.h>

namespace pointmill {

/// @brief Makes CL points of the moves of the player's program, for programs that come
/// without them: cuts, and rapids, in passes from one rapid to the next, an operation
/// for each section. Moves from or to where nobody knows are left out.
void addProgramPath(ViewerScene& scene);

} // namespace pointmill
