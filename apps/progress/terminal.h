// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill {

/// @brief Whether somebody looks at what is written to this file descriptor.
bool isTerminal(int descriptor);

/// @brief Whether colours may be written to it: to a terminal that is not `TERM=dumb`,
/// and only where `NO_COLOR` is not set (https://no-color.org).
bool takesColours(int descriptor);

/// @brief Columns of a terminal as wide as it is now; 80 where it does not tell.
int terminalWidth(int descriptor);

} // namespace pointmill
