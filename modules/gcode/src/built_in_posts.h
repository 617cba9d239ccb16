// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pointmill::gcode {

/// @brief Names and descriptions of the built-in posts; a `base` stands above those
/// that build on it.
const std::vector<std::pair<std::string, std::string>>& builtInPosts();

} // namespace pointmill::gcode
