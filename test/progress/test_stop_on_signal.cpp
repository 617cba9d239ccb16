// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "progress/stop_on_signal.h"

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <stdexcept>

using namespace pointmill;

namespace {

volatile std::sig_atomic_t others = 0;

void otherHandler(int)
{
  others = others + 1;
}

/// What a signal does is what it did before, after the test.
class Signals : public testing::Test {
protected:
  Signals() : interrupt_(std::signal(SIGINT, SIG_IGN)), pipe_(handlerOf(SIGPIPE))
  {
    std::signal(SIGPIPE, otherHandler);
    others = 0;
  }
  ~Signals() override
  {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGPIPE, pipe_);
  }
  static void (*handlerOf(int signal))(int)
  {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    return now.sa_handler;
  }

private:
  void (*interrupt_)(int);
  void (*pipe_)(int);
};

} // namespace

TEST_F(Signals, StopTheWatchAndThenDoWhatTheyDidBefore)
{
  {
    Watch watch;
    const StopOnSignal stop(watch);
    EXPECT_FALSE(watch.stopped());
    std::raise(SIGPIPE);
    EXPECT_TRUE(watch.stopped());
    EXPECT_EQ(others, 0);
  }
  std::raise(SIGPIPE); // the watch is gone
  EXPECT_EQ(others, 1);
  EXPECT_EQ(handlerOf(SIGINT), SIG_IGN);
  EXPECT_EQ(interruptedExitCode(), 128 + SIGPIPE);
}

TEST_F(Signals, DoWhatTheyDidBeforeAfterAnErrorToo)
{
  try {
    Watch watch;
    const StopOnSignal stop(watch);
    throw std::runtime_error("an error");
  }
  catch (const std::runtime_error&) {
    std::raise(SIGPIPE);
  }
  EXPECT_EQ(others, 1);
  EXPECT_EQ(handlerOf(SIGINT), SIG_IGN);
}
