// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/gcode/decimal_grid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

using pointmill::DecimalGrid;

namespace {

std::string shown(const DecimalGrid& grid, std::int64_t ticks)
{
  char text[DecimalGrid::max_chars];
  return std::string(&text[0], grid.write(text, ticks));
}

std::string shown(double value)
{
  const DecimalGrid grid(4);
  return shown(grid, grid.nearest(value));
}

} // namespace

TEST(DecimalGrid, PrintsShortAndWithAPoint)
{
  EXPECT_EQ(shown(10.0), "10.");
  EXPECT_EQ(shown(123456.5), "123456.5");
  EXPECT_EQ(shown(0.5), "0.5");
  EXPECT_EQ(shown(-0.5), "-0.5");
  EXPECT_EQ(shown(-1.0001), "-1.0001");
  EXPECT_EQ(shown(100.02), "100.02");
  EXPECT_EQ(shown(100.0020), "100.002");
  EXPECT_EQ(shown(1e9), "1000000000.");
}

TEST(DecimalGrid, HasNoExponentAndNoNegativeZero)
{
  EXPECT_EQ(shown(1e-7), "0.");
  EXPECT_EQ(shown(-0.00004), "0.");
  EXPECT_EQ(shown(-0.0), "0.");
  EXPECT_EQ(shown(0.00006), "0.0001");
  EXPECT_EQ(shown(-0.00006), "-0.0001");
}

TEST(DecimalGrid, OtherCountsOfDecimals)
{
  EXPECT_EQ(shown(DecimalGrid(1), DecimalGrid(1).nearest(-3.14159)), "-3.1");
  EXPECT_EQ(shown(DecimalGrid(6), DecimalGrid(6).nearest(-3.14159265)), "-3.141593");
  EXPECT_THROW(DecimalGrid(-1), pointmill::ParameterError);
  EXPECT_THROW(DecimalGrid(7), pointmill::ParameterError);
}

TEST(DecimalGrid, RoundsUpwardsNeverBelow)
{
  const DecimalGrid grid(4);
  EXPECT_EQ(grid.atOrAbove(0.00001f), 1);
  EXPECT_EQ(grid.atOrAbove(-0.00009f), 0);
  EXPECT_EQ(grid.atOrAbove(-1.00001f), -10000);

  std::mt19937 random(1);
  std::uniform_real_distribution<float> z(-2000.f, 2000.f);
  for (int i = 0; i < 100000; ++i) {
    const float value = i % 2 ? z(random) : z(random) / 1000;
    const double written = grid.value(grid.atOrAbove(value));
    // As the float that the point holds; 5 nm are float's own noise.
    ASSERT_GE(static_cast<float>(written), value);
    ASSERT_GE(written, double(value) - 5.0e-6);
    ASSERT_LT(written, double(value) + 1.0e-4);
  }
}

TEST(DecimalGrid, AFloatThatMeansADecimalIsThatDecimal)
{
  // -1.3f lies above -1.3, -3.7f below -3.7: both are what somebody typed.
  const DecimalGrid grid(4);
  for (int i = -200000; i <= 200000; ++i)
    ASSERT_EQ(grid.atOrAbove(static_cast<float>(i / 1e4)), i);
}
