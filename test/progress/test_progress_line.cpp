// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <progress/progress_line.h>

#include <gtest/gtest.h>

using pointmill::Progress;
using pointmill::progressLine;

namespace {

Progress half()
{
  return {"finishing", 0.5, 75, 3725.0};
}

} // namespace

TEST(ProgressLine, NamesStageShareAndTimes)
{
  EXPECT_EQ(progressLine(half(), 79),
            "finishing           [############             ]  50 %  1:15, about "
            "1:02:05 left");
  Progress unknown = half();
  unknown.left.reset();
  EXPECT_EQ(progressLine(unknown, 59),
            "finishing           [############             ]  50 %  1:15");
}

TEST(ProgressLine, FitsAnyWidth)
{
  for (int width = 0; width < 200; ++width) {
    EXPECT_LE(progressLine(half(), width).size(), static_cast<std::size_t>(width));
    Progress longer = half();
    longer.stage = "rest roughing with a rather long name, T4";
    EXPECT_LE(progressLine(longer, width).size(), static_cast<std::size_t>(width));
  }
  EXPECT_EQ(progressLine(half(), 30), "finishing  50 %");
  EXPECT_EQ(progressLine(half(), 41), "finishing  50 %  1:15, about 1:02:05 left");
}

TEST(ProgressLine, WhatIsNotDoneIsNotAHundredPerCent)
{
  Progress nearly = half();
  nearly.share = 0.9999;
  EXPECT_NE(progressLine(nearly, 79).find(" 99 %"), std::string::npos);
  nearly.share = 1;
  EXPECT_NE(progressLine(nearly, 79).find("100 %"), std::string::npos);
}
