// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>
#include <vector>

namespace pointmill::gcode {

/// @brief @p text as the insides of RS-274 comments: printable ASCII without
/// parentheses, at most 78 characters each, and never a comment that LinuxCNC would
/// obey, as "MSG,".
std::vector<std::string> commentLines(const std::string& text);

} // namespace pointmill::gcode
