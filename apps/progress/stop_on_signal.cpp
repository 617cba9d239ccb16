// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stop_on_signal.h"

#include <atomic>
#include <csignal>
#include <ctime>

namespace pointmill {
namespace {

constexpr int kSignalled = 128; // added to a signal's number

/// People press Ctrl-C again soon; that must not leave anything half written.
constexpr std::time_t kPatience = 2; // s

std::atomic<Watch*> watch{nullptr};
std::atomic<int> first_signal{0};
std::atomic<std::time_t> first_time{0};

// Only what may be called in a signal handler.
void onSignal(int signal)
{
  int none = 0;
  if (first_signal.compare_exchange_strong(none, signal))
    first_time = std::time(nullptr);
  else if (signal != SIGPIPE && std::time(nullptr) - first_time > kPatience) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (Watch* told = watch)
    told->stop();
}

} // namespace

StopOnSignal::StopOnSignal(Watch& stopped) : watch_before_(watch.exchange(&stopped))
{
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (kSignals[i] != SIGHUP || before_[i].sa_handler != SIG_IGN) // nohup stays
      sigaction(kSignals[i], &action, nullptr);
  }
}

StopOnSignal::~StopOnSignal()
{
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    sigaction(kSignals[i], &before_[i], nullptr);
  watch = watch_before_;
}

int interruptedExitCode()
{
  const int signal = first_signal;
  return kSignalled + (signal != 0 ? signal : SIGINT);
}

} // namespace pointmill
