// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <progress/pace.h>

#include <gtest/gtest.h>

using pointmill::Pace;

TEST(Pace, SaysNothingBeforeThereIsSomethingToTellItBy)
{
  Pace pace;
  pace.note(1.0, 0.5); // too soon
  EXPECT_FALSE(pace.left());
  pace.note(60.0, 0.01); // too little
  EXPECT_FALSE(pace.left());
  pace.note(61.0, 0.1);
  EXPECT_TRUE(pace.left());
}

TEST(Pace, IsExactWhereTheWorkIsEven)
{
  Pace pace;
  for (double t = 0; t <= 100; t += 0.1) {
    pace.note(t, t / 100);
    if (pace.left()) {
      EXPECT_NEAR(*pace.left(), 100 - t, 1e-6);
    }
  }
  EXPECT_TRUE(pace.left());
}

TEST(Pace, FollowsAChangeCalmly)
{
  // Twice as slow from the middle on.
  const auto share = [](double t) { return t < 50 ? t / 100 : 0.5 + (t - 50) / 200; };
  Pace pace;
  double before = 0;
  for (double t = 0; t <= 150; t += 0.1) {
    pace.note(t, share(t));
    const double left = pace.left().value_or(0);
    if (t > 10) {
      EXPECT_NEAR(left, before, 1.0) << t << " s";
    }
    before = left;
  }
  EXPECT_NEAR(before, 0, 1.0);
}

TEST(Pace, IsNeverNegative)
{
  Pace pace;
  pace.note(3, 0.9);
  for (double t = 4; t < 30; t += 1) {
    pace.note(t, 1.0);
    EXPECT_GE(*pace.left(), 0);
  }
}
