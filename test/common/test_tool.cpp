// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/tool.h>

#include <gtest/gtest.h>

using pointmill::Tool;

TEST(Tool, ProfileOfABallIsItsSphere)
{
  const Tool ball = Tool::ball(1, 6.0);
  for (double r = 0; r <= 3.0; r += 0.25)
    EXPECT_DOUBLE_EQ(ball.profile(r), 3.0 - std::sqrt(9.0 - r * r));
  EXPECT_TRUE(std::isinf(ball.profile(3.001)));
}

TEST(Tool, ProfileOfAFlatIsZero)
{
  const Tool flat = Tool::flat(1, 10.0);
  EXPECT_EQ(flat.profile(0.0), 0.0);
  EXPECT_EQ(flat.profile(5.0), 0.0);
  EXPECT_TRUE(std::isinf(flat.profile(5.001)));
}

TEST(Tool, ProfileOfABullIsFlatThenRound)
{
  const Tool bull = Tool::bull(1, 10.0, 2.0);
  EXPECT_EQ(bull.profile(3.0), 0.0);
  EXPECT_DOUBLE_EQ(bull.profile(4.0), 2.0 - std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(bull.profile(5.0), 2.0);
}

TEST(Tool, AGrownToolIsTheOffsetSurface)
{
  // A ball of radius 3 grown by 0.5 is a ball of radius 3.5.
  const Tool grown = Tool::ball(1, 6.0).grown(0.5);
  EXPECT_DOUBLE_EQ(grown.radius(), 3.5);
  EXPECT_TRUE(grown.isBall());
  EXPECT_EQ(Tool::flat(1, 10.0).grown(0.5).corner_radius, 0.5);
}

TEST(Tool, NonsenseIsRefusedByName)
{
  EXPECT_THROW(Tool::flat(1, 0.0).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::flat(1, std::nan("")).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::bull(1, 4.0, 2.5).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::flat(0, 4.0).validate(), pointmill::ParameterError);
  EXPECT_NO_THROW(Tool::ball(3, 3.0).validate());
}
