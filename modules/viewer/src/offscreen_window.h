// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace pointmill::viewer {

/// @brief A window that is nowhere shown and needs no display: OpenGL by EGL, in
/// software where there is no graphics card.
/// @throws Error where the machine has no OpenGL 3.2 at all
vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height);

} // namespace pointmill::viewer
