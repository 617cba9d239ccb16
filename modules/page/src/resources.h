// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string_view>

/// @brief Files that are built into the program, see modules/page/CMakeLists.txt.
namespace pointmill::resources {

extern const std::string_view page, style, view, view_script, three, orbit_controls,
    three_licence;

} // namespace pointmill::resources
