// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/watch.h>

#include <array>
#include <csignal>

namespace pointmill {

/// @brief While it lives, Ctrl-C (SIGINT), SIGTERM, SIGHUP and SIGPIPE stop what a
/// Watch watches, which cleans up and throws Interrupted, instead of ending the program
/// anywhere. Should that hang, another one over two seconds later ends it at once.
/// Afterwards signals do again what they did before.
class StopOnSignal {
public:
  /// @param watch must outlive this
  explicit StopOnSignal(Watch& watch);
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

private:
  static constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGPIPE, SIGHUP};

  std::array<struct sigaction, 4> before_{};
  Watch* watch_before_;
};

/// @brief The exit code that shells expect after the signal that came: 130 after
/// Ctrl-C, 143 after SIGTERM; 130 too where none came.
int interruptedExitCode();

} // namespace pointmill
