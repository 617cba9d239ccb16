// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>

#include <atomic>
#include <mutex>
#include <string>

namespace pointmill {

/// @brief Thrown out of whatever computes after Watch::stop() was called. As with any
/// Error, outputs are untouched and no file stays half written.
class Interrupted : public Error {
public:
  Interrupted() : Error("interrupted") {}
};

/// @brief A part of a computation, as shares of what is around it; this one is nothing
/// of it.
struct Share {
  double begin = 0.0, end = 0.0;
};

class Watch;

namespace detail {
/// Who watches this thread, and which part of the whole its work is.
struct Place {
  Watch* watch = nullptr;
  double begin = 0.0, end = 0.0;
};
Place& here() noexcept;
} // namespace detail

/// @brief Watches what is computed in the thread that made it, from then on until it is
/// destroyed: tells others how far that is, and stops it when they want.
///
/// @code
/// pointmill::Watch watch;     // in the thread that computes
/// stage.filter(output);       // throws Interrupted soon after watch.stop()
/// // meanwhile, in any other thread: watch.share(), watch.stage(), watch.stop()
/// @endcode
///
/// All stages take part, with the threads that they start. Where there is no Watch they
/// tell nobody and run to their end, at no cost. A second one in the same thread takes
/// the first one's place until it is destroyed.
class Watch {
public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// @brief Lets what is watched throw Interrupted, within a fraction of a second. May
  /// be called in any thread, and by a signal handler.
  void stop() noexcept { stopped_ = true; }
  bool stopped() const noexcept { return stopped_; }

  /// @brief How much is done, from 0 to 1; never less than before.
  double share() const noexcept { return share_; }
  /// @brief What is being done, as the last WorkStep with a name called it.
  std::string stage() const;

private:
  friend class WorkStep;

  static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers need that");
  std::atomic<bool> stopped_{false};
  std::atomic<double> share_{0.0};
  mutable std::mutex mutex_;
  std::string stage_;
  detail::Place around_;
};

/// @brief Throws Interrupted if the Watch of this thread was stopped. For loops that
/// take long: once in a millisecond or so, never in the innermost ones.
void checkInterrupted();

/// @brief While it lives, what its thread does is this share of the WorkStep around it,
/// or of all. The last one that lives is the first to end, as variables of blocks are.
///
/// @code
/// const WorkStep rows({0.2, 0.9}); // of the stage's work
/// for (std::size_t i = 0; i < count; ++i) {
///   rows.reach(double(i) / double(count));
/// @endcode
class WorkStep {
public:
  /// @throws Interrupted
  explicit WorkStep(Share share);
  /// @brief A step that has a name, for Watch::stage().
  WorkStep(const std::string& stage, Share share);
  /// @brief All of it is done, unless an exception ends it.
  ~WorkStep();
  WorkStep(const WorkStep&) = delete;
  WorkStep& operator=(const WorkStep&) = delete;

  /// @brief This share of it is done. @throws Interrupted
  void reach(double share) const;

private:
  void tell(double place) const noexcept;

  detail::Place around_, mine_;
  int exceptions_;
};

} // namespace pointmill
