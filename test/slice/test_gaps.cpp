// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/gaps.h>

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace pointmill;

namespace {

CellGrid unitGrid(int columns, int rows)
{
  CellGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  return grid;
}

int countOf(const std::vector<unsigned char>& mask)
{
  return std::accumulate(mask.begin(), mask.end(), 0);
}

} // namespace

TEST(DistanceField, EqualsBruteForce)
{
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round) {
    const int columns = 23, rows = 17;
    std::vector<unsigned char> mask(columns * rows, 0);
    for (int k = 0; k < 1 + 6 * round; ++k)
      mask[random() % mask.size()] = 1;
    const auto field = distanceField(mask, columns, rows);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        double truth = INFINITY;
        for (int i = 0; i < columns * rows; ++i)
          if (mask[i])
            truth = std::min(truth, std::hypot(i % columns - c, i / columns - r));
        ASSERT_FLOAT_EQ(field[r * columns + c], float(truth));
      }
  }
  for (const float d : distanceField(std::vector<unsigned char>(12, 0), 4, 3))
    EXPECT_TRUE(std::isinf(d));
}

TEST(Gaps, AHoleIsAGapAndABayIsNot)
{
  const CellGrid grid = unitGrid(30, 30);
  std::vector<unsigned char> occupied(grid.size(), 1);
  for (int r = 10; r < 20; ++r)
    for (int c = 10; c < 20; ++c)
      occupied[grid.index(c, r)] = 0; // enclosed
  for (int r = 0; r < 6; ++r)
    for (int c = 12; c < 18; ++c)
      occupied[grid.index(c, r)] = 0; // open to the outside, 6 wide
  const auto gaps = findGaps(grid, occupied, 1.5);
  EXPECT_EQ(countOf(gaps), 100 + 0);
  EXPECT_TRUE(gaps[grid.index(15, 15)]);
  EXPECT_FALSE(gaps[grid.index(15, 2)]);
  const auto regions = gapRegions(grid, occupied, gaps, 1.5);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_DOUBLE_EQ(regions[0].area, 100);
  EXPECT_NEAR(regions[0].centre.x(), 15, 1e-9);
  EXPECT_EQ(regions[0].min.y(), 10);
  EXPECT_EQ(regions[0].max.x(), 20);
  EXPECT_FALSE(regions[0].between_points);
}

TEST(Gaps, SparsePointsAreNoGap)
{
  const CellGrid grid = unitGrid(40, 40);
  std::vector<unsigned char> occupied(grid.size(), 0);
  for (int r = 0; r < 40; r += 3)
    for (int c = 0; c < 40; c += 3)
      occupied[grid.index(c, r)] = 1;
  const auto gaps = findGaps(grid, occupied, 3.0);
  EXPECT_TRUE(gaps[grid.index(20, 20)] || occupied[grid.index(20, 20)]);
  for (const auto& region : gapRegions(grid, occupied, gaps, 3.0))
    EXPECT_TRUE(region.between_points);
}

TEST(Gaps, TheBridgeOverASlopeIsTheSlope)
{
  // A plane is harmonic: the membrane restores it exactly.
  const CellGrid grid = unitGrid(25, 20);
  std::vector<unsigned char> gaps(grid.size(), 0);
  std::vector<double> height(grid.size());
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const bool gap = c > 5 && c < 20 && r > 4 && r < 15;
      gaps[grid.index(c, r)] = gap;
      height[grid.index(c, r)] = gap ? NAN : 2 + 0.5 * c - 0.25 * r;
    }
  bridgeGaps(grid, gaps, height);
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      EXPECT_NEAR(height[grid.index(c, r)], 2 + 0.5 * c - 0.25 * r, 1e-9);
}

TEST(Gaps, TheBridgeStaysWithinItsRim)
{
  const CellGrid grid = unitGrid(40, 40);
  std::vector<unsigned char> gaps(grid.size(), 0);
  std::vector<double> height(grid.size());
  std::mt19937 random(4);
  for (int r = 0; r < 40; ++r)
    for (int c = 0; c < 40; ++c) {
      const bool gap = std::hypot(c - 20, r - 20) < 12;
      gaps[grid.index(c, r)] = gap;
      height[grid.index(c, r)] = gap ? NAN : c < 20 ? 5 : (random() % 1000) / 1000.0;
    }
  bridgeGaps(grid, gaps, height);
  for (std::size_t i = 0; i < height.size(); ++i)
    if (gaps[i]) {
      EXPECT_GE(height[i], 0.0);
      EXPECT_LE(height[i], 5.0);
    }
}
