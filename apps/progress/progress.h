// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "progress/pace.h"

#include <pointmill/common/watch.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace pointmill {

/// @brief How far a computation is.
struct Progress {
  std::string stage;
  double share = 0;           ///< from 0 to 1, never less than before
  double seconds = 0;         ///< since it began
  std::optional<double> left; ///< seconds, where there is something to tell them by
};

/// @brief Looks at a Watch again and again, in a thread of its own, and tells what it
/// sees: from the first second on, for nothing shorter needs it, until this is
/// destroyed.
class ProgressTeller {
public:
  using Tell = std::function<void(const Progress&)>;

  /// @param period [s]
  /// @param tell is called in that thread, must not throw
  ProgressTeller(const Watch& watch, double period, Tell tell);
  ~ProgressTeller();
  ProgressTeller(const ProgressTeller&) = delete;
  ProgressTeller& operator=(const ProgressTeller&) = delete;

private:
  void run(double period);

  const Watch& watch_;
  const Tell tell_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};

} // namespace pointmill
