// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "progress.h"

#include <csignal>
#include <utility>

namespace pointmill {
namespace {

constexpr double kFirst = 1.0; // s

/// A thread that is started while this lives gets no signals: they are for the others.
class SignalsBlocked {
public:
  SignalsBlocked()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

private:
  sigset_t before_;
};

} // namespace

ProgressTeller::ProgressTeller(const Watch& watch, double period, Tell tell)
    : watch_(watch), tell_(std::move(tell))
{
  const SignalsBlocked blocked;
  thread_ = std::thread([this, period] { run(period); });
}

ProgressTeller::~ProgressTeller()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void ProgressTeller::run(double period)
{
  using Seconds = std::chrono::duration<double>;
  Pace pace;
  std::unique_lock<std::mutex> lock(mutex_);
  for (double next = kFirst;; next += period) {
    const auto when =
        start_ +
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(Seconds(next));
    if (wake_.wait_until(lock, when, [&] { return ended_; }))
      return;
    const Seconds since = std::chrono::steady_clock::now() - start_;
    Progress progress{watch_.stage(), watch_.share(), since.count(), {}};
    pace.note(progress.seconds, progress.share);
    progress.left = pace.left();
    lock.unlock(); // to tell may take long, where a terminal holds its output
    tell_(progress);
    lock.lock();
  }
}

} // namespace pointmill
