// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/cell_regions.h>

#include <gtest/gtest.h>

using namespace pointmill;

namespace {

// x x . .
// . . x .     two pieces meet by a corner, a third stands apart
// x . . .
const CellGrid kGrid = CellGrid::covering({0, 0}, {3.5, 2.5}, 1.0);
const std::vector<unsigned char> kMask{1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0};
using Regions = std::vector<std::vector<std::size_t>>;

} // namespace

TEST(CellRegions, ConnectByEdgesOrByCornersToo)
{
  ASSERT_EQ(kGrid.columns, 4);
  ASSERT_EQ(kGrid.rows, 3);
  EXPECT_EQ(cellRegions(kGrid, kMask, Connected::Edges), (Regions{{0, 1}, {6}, {8}}));
  EXPECT_EQ(cellRegions(kGrid, kMask, Connected::Corners), (Regions{{0, 1, 6}, {8}}));
}

TEST(CellRegions, AreTakenOutOfTheMask)
{
  auto mask = kMask;
  std::vector<std::size_t> region{1};
  takeRegion(kGrid, mask, Connected::Edges, region);
  EXPECT_EQ(region, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(mask, (std::vector<unsigned char>{0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0}));
}
