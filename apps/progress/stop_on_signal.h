// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/watch.h>

namespace pointmill {

/// @brief From now on Ctrl-C (SIGINT), SIGTERM, SIGHUP and SIGPIPE stop what @p watch
/// watches, which cleans up and throws Interrupted, instead of ending the program
/// anywhere. Should that hang, another one over two seconds later ends it at once.
///
/// @param watch must live as long as the program takes signals, as one in main() does
void stopOnSignal(Watch& watch);

/// @brief Signals end the program at once again: when nothing is computed any more, as
/// while a window is open.
void signalsAsBefore();

/// @brief The exit code that shells expect after the signal that came: 130 after
/// Ctrl-C, 143 after SIGTERM; 130 too where none came.
int interruptedExitCode();

} // namespace pointmill
