// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/gaps.h>

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

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

/// The occupied cells at height z, NaN elsewhere.
std::vector<double> heightsOf(const std::vector<unsigned char>& occupied, double z)
{
  std::vector<double> height(occupied.size(), NAN);
  for (std::size_t i = 0; i < occupied.size(); ++i)
    if (occupied[i])
      height[i] = z;
  return height;
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
  const auto regions =
      gapRegions(grid, wideGaps(grid, occupied, gaps, 1.5), heightsOf(occupied, 2.0));
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_DOUBLE_EQ(regions[0].area, 100);
  EXPECT_NEAR(regions[0].centre.x(), 15, 1e-9);
  EXPECT_EQ(regions[0].min.y(), 10);
  EXPECT_EQ(regions[0].max.x(), 20);
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
  EXPECT_EQ(countOf(wideGaps(grid, occupied, gaps, 3.0)), 0);
}

TEST(Gaps, ARealGapAmongSparsePointsIsOnlyAsWideAsItIs)
{
  const CellGrid grid = unitGrid(60, 60);
  std::vector<unsigned char> occupied(grid.size(), 0);
  for (int r = 0; r < 60; r += 2)
    for (int c = 0; c < 60; c += 2)
      occupied[grid.index(c, r)] = std::hypot(c - 30, r - 30) > 10;
  const auto wide = wideGaps(grid, occupied, findGaps(grid, occupied, 3.0), 3.0);
  EXPECT_TRUE(wide[grid.index(30, 30)]);
  EXPECT_FALSE(wide[grid.index(5, 5)]);
  EXPECT_NEAR(countOf(wide), M_PI * 100, 60);
  EXPECT_EQ(gapRegions(grid, wide, heightsOf(occupied, 2.0)).size(), 1u);
}

TEST(Gaps, BetweenPointsOfASlopeLiesTheSlope)
{
  const CellGrid grid = unitGrid(40, 40);
  std::vector<unsigned char> between(grid.size(), 1);
  std::vector<double> height(grid.size(), NAN);
  std::vector<Eigen::Vector3f> points;
  std::mt19937 random(6);
  for (int i = 0; i < 400; ++i) { // every other cell, somewhere in it
    const float x = float(i % 20) * 2 + float(random() % 100) / 100;
    const float y = float(i / 20) * 2 + float(random() % 100) / 100;
    points.emplace_back(x, y, 2 * x - y);
    const auto at = grid.index(grid.columnOf(x), grid.rowOf(y));
    between[at] = 0;
  }
  fillBetweenPoints(grid, between, points, height);
  for (int r = 8; r < 32; ++r)
    for (int c = 8; c < 32; ++c)
      if (between[grid.index(c, r)]) {
        EXPECT_NEAR(height[grid.index(c, r)], 2 * grid.x(c) - grid.y(r), 1e-3);
      }
}

TEST(Gaps, BetweenPointsInALineLiesTheirMean)
{
  const CellGrid grid = unitGrid(10, 10);
  std::vector<unsigned char> between(grid.size(), 0);
  between[grid.index(5, 5)] = 1;
  std::vector<double> height(grid.size(), NAN);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(2.f + i, 3.f, i % 2 ? 1.f : 3.f);
  fillBetweenPoints(grid, between, points, height);
  EXPECT_NEAR(height[grid.index(5, 5)], 2.0, 1e-6);
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

TEST(Gaps, TheBridgeKeepsToItsOwnRimToTheLastBit)
{
  // Level rims of heights that no binary fraction is: the membrane may not be lower by
  // a bit, nor may one gap's rim bear on another.
  const CellGrid grid = unitGrid(60, 30);
  std::vector<unsigned char> gaps(grid.size(), 0);
  std::vector<double> height(grid.size());
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 60; ++c) {
      gaps[grid.index(c, r)] = std::hypot(c % 30 - 15, r - 15) < 11;
      height[grid.index(c, r)] = gaps[grid.index(c, r)] ? NAN : c < 30 ? 0.1 : 7.7;
    }
  bridgeGaps(grid, gaps, height);
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 60; ++c)
      EXPECT_EQ(height[grid.index(c, r)], c < 30 ? 0.1 : 7.7);
}

TEST(Gaps, ABridgeThatIsOpenToTheOutsideKeepsToItsRim)
{
  // A bay with a rim on three sides; on the fourth the outline ends and the membrane is
  // free.
  const CellGrid grid = unitGrid(30, 20);
  std::vector<unsigned char> gaps(grid.size(), 0);
  std::vector<double> height(grid.size());
  std::mt19937 random(8);
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 30; ++c) {
      const bool outside = c >= 25;
      gaps[grid.index(c, r)] = c > 5 && !outside && r > 4 && r < 15;
      height[grid.index(c, r)] =
          gaps[grid.index(c, r)] || outside ? NAN : 3 + double(random() % 1000) / 999;
    }
  const auto regions = gapRegions(grid, gaps, height);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_TRUE(regions[0].open);
  bridgeGaps(grid, gaps, height);
  for (const auto at : regions[0].cells) {
    EXPECT_GE(height[at], regions[0].rim_low);
    EXPECT_LE(height[at], regions[0].rim_high);
  }
}

TEST(Gaps, ARegionKnowsItsRimAndItsCells)
{
  const CellGrid grid = unitGrid(20, 20);
  std::vector<unsigned char> gaps(grid.size(), 0);
  std::vector<double> height(grid.size());
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 20; ++c) {
      gaps[grid.index(c, r)] = c >= 8 && c < 12 && r >= 8 && r < 11;
      height[grid.index(c, r)] = gaps[grid.index(c, r)] ? NAN : 10 + c;
    }
  height[grid.index(0, 0)] = -50; // not beside the gap
  const auto regions = gapRegions(grid, gaps, height);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].rim_low, 17);
  EXPECT_EQ(regions[0].rim_high, 22);
  EXPECT_FALSE(regions[0].open);
  EXPECT_EQ(regions[0].kind, GapKind::NotScanned);
  EXPECT_EQ(regions[0].cells.size(), 12u);
  for (const auto at : regions[0].cells)
    EXPECT_TRUE(gaps[at]);
}

TEST(Gaps, ABridgeFromNothingIsRefused)
{
  const CellGrid grid = unitGrid(5, 5);
  std::vector<double> height(grid.size(), NAN);
  EXPECT_THROW(bridgeGaps(grid, std::vector<unsigned char>(25, 1), height), DataError);
}

TEST(Gaps, ThroughHolesAreNamedByAPlaceInThem)
{
  const CellGrid grid = unitGrid(40, 20);
  std::vector<unsigned char> gaps(grid.size(), 0);
  for (int r = 5; r < 15; ++r)
    for (int c = 5; c < 30; ++c)
      gaps[grid.index(c, r)] = c < 15 || c > 25; // 10 and 4 wide
  auto regions = gapRegions(grid, gaps, std::vector<double>(grid.size(), 1.0));
  ASSERT_EQ(regions.size(), 2u);
  nameThroughHoles(grid, {{26.5, 5.1}}, regions);
  EXPECT_EQ(regions[0].kind, GapKind::NotScanned);
  EXPECT_EQ(regions[1].kind, GapKind::ThroughHole);
  EXPECT_EQ(regions[1].treatment, GapPolicy::Mill);

  // A miss changes nothing and says where the nearest gap is.
  try {
    nameThroughHoles(grid, {{10, 10}, {18, 10}}, regions);
    FAIL();
  }
  catch (const ParameterError& e) {
    EXPECT_NE(std::string(e.what()).find("100 mm2 about X10 Y10, begins 3 mm away"),
              std::string::npos)
        << e.what();
  }
  EXPECT_EQ(regions[0].kind, GapKind::NotScanned);
  regions.clear();
  EXPECT_THROW(nameThroughHoles(grid, {{1, 1}}, regions), ParameterError);
  EXPECT_THROW(nameThroughHoles(grid, {{NAN, 1}}, regions), ParameterError);
}
