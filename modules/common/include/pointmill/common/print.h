// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

namespace pointmill {

/// @brief What printf would print, of up to 511 characters.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
print(const char* format, ...);

} // namespace pointmill
