// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

namespace pointmill {

/// @brief What printf would print.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
print(const char* format, ...);

/// @brief "2 h 05 min", "35 min", to the nearest minute, as the page's script does.
std::string hoursAndMinutes(double minutes);

} // namespace pointmill
