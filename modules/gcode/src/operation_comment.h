// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <optional>
#include <string_view>

namespace pointmill::gcode {

/// @brief "finishing" of the comment "Operation 2: finishing", in any case; nothing
/// where a comment says something else. Where a control's comments have no colon, '-',
/// '.', '=' or ',' stand for it.
std::optional<std::string_view> operationName(std::string_view comment);

} // namespace pointmill::gcode
