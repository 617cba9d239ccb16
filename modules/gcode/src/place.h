// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <string>

namespace pointmill::gcode {

/// @brief A place in a program's text; both count from 1.
struct Place {
  std::size_t line = 0;
  int column = 0;
};

/// @brief Throws DataError "line 12, column 5: " and @p what.
[[noreturn]] void refuse(Place place, const std::string& what);

/// @brief A character as an error shows it: 'x', or "byte 0xC3".
std::string shown(char c);

} // namespace pointmill::gcode
