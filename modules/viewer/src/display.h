// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill::viewer {

/// @brief Whether windows can be opened: VTK ends the program where they cannot.
bool hasDisplay();

} // namespace pointmill::viewer
