// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/occupancy_picture.h>

#include <cmath>

using namespace pointmill;

namespace {

const Pixel kRed{0xC8, 0x28, 0x1E}, kYellow{0xF6, 0xD7, 0x43}, kBlue{0x5B, 0x7C, 0x99};
constexpr int kLegendBox = 400; // px at most

/// 10 x 8 cells of 2 mm: a left half 10 mm high, a right half 4 mm high with two gaps
/// bridged at 9 and 3 mm, and an empty top row.
CellCloud smallMap()
{
  CellCloud map;
  map.resize(80);
  map.width = 10;
  map.height = 8;
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 10; ++c) {
      PointCell& cell = map[r * 10 + c];
      cell.x = static_cast<float>(2 * c + 1);
      cell.y = static_cast<float>(2 * r + 1);
      if (r == 7)
        continue;
      cell.z = c < 5 ? 10.f : 4.f;
      cell.setState(CellState::Occupied);
    }
  for (const int i : {17, 18}) {
    map[i].setState(CellState::Gap);
    map[i].z = i == 17 ? 9.f : 3.f;
  }
  return map;
}

} // namespace

TEST(OccupancyPicture, EveryCellIsASquareOfItsColour)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("map.png");
  writeOccupancy(path, smallMap(), 6.0);
  const Picture picture(path);
  EXPECT_EQ(picture.channels(), 3);
  const int cell = 140 * 140; // 1400 px for ten cells
  EXPECT_NEAR(picture.count(kRed), 35 * cell, kLegendBox);
  EXPECT_NEAR(picture.count(kBlue), 1 * cell, kLegendBox);
  EXPECT_NEAR(picture.count(kYellow), 44 * cell, kLegendBox);
}

TEST(OccupancyPicture, XRunsRightAndYRunsUp)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("map.png");
  writeOccupancy(path, smallMap(), 6.0);
  const Picture picture(path);
  const int left = (picture.width() - 1400) / 2, middle = picture.height() / 2;
  EXPECT_EQ(picture.at(left + 70, middle), kRed);
  EXPECT_EQ(picture.at(left + 1330, middle), kYellow);
  int top = 0; // the empty row
  while (picture.at(left + 70, top) != kYellow)
    ++top;
  EXPECT_EQ(picture.at(left + 70, top + 139), kYellow);
  EXPECT_EQ(picture.at(left + 70, top + 140), kRed);
}

TEST(OccupancyPicture, ALevelBelowAllShowsBothGaps)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("map.png");
  CellCloud map = smallMap();
  map[17].z = std::nanf(""); // unknown is protected too
  writeOccupancy(path, map, 0.0);
  const Picture picture(path);
  EXPECT_NEAR(picture.count(kBlue), 2 * 140 * 140, kLegendBox);
  EXPECT_NEAR(picture.count(kRed), 68 * 140 * 140, kLegendBox);
}

TEST(OccupancyPicture, RefusesMapsItCannotShow)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("map.png");
  EXPECT_THROW(writeOccupancy(path, CellCloud(), 0.0), DataError);
  CellCloud row = smallMap();
  row.width = 80;
  row.height = 1;
  EXPECT_THROW(writeOccupancy(path, row, 0.0), DataError);
  CellCloud torn = smallMap();
  torn.points.resize(79);
  EXPECT_THROW(writeOccupancy(path, torn, 0.0), DataError);
  EXPECT_TRUE(folder.empty());
}

TEST(OccupancyPicture, AnUnwritablePathLeavesNothing)
{
  const TemporaryFolder folder;
  EXPECT_THROW(writeOccupancy(folder.file("no/such/map.png"), smallMap(), 6.0),
               DataError);
  // A folder in the way: the picture is written beside it, but cannot be renamed.
  std::filesystem::create_directories(folder.file("map.png/inside"));
  EXPECT_THROW(writeOccupancy(folder.file("map.png"), smallMap(), 6.0), DataError);
  EXPECT_EQ(folder.files(), 1u);
}
