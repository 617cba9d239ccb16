// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <progress/progress.h>

#include <gtest/gtest.h>

#include <future>

using namespace pointmill;

TEST(ProgressTeller, TellsWhatTheWatchedThreadDoes)
{
  const Watch watch;
  const WorkStep step("reading", {0.0, 0.5});
  step.reach(0.5);
  std::promise<Progress> first;
  bool told = false;
  const ProgressTeller teller(watch, 0.01, [&](const Progress& progress) {
    if (!told)
      first.set_value(progress);
    told = true;
  });
  const Progress progress = first.get_future().get();
  EXPECT_EQ(progress.stage, "reading");
  EXPECT_DOUBLE_EQ(progress.share, 0.25);
  EXPECT_GE(progress.seconds, 1.0); // what is shorter needs none
  EXPECT_FALSE(progress.left);
}

TEST(ProgressTeller, EndsAtOnceAndTellsNothingOfWhatIsShort)
{
  const Watch watch;
  bool told = false;
  {
    const ProgressTeller teller(watch, 0.01, [&](const Progress&) { told = true; });
  }
  EXPECT_FALSE(told);
}
