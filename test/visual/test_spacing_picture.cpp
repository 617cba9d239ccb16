// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/spacing_picture.h>

#include <cmath>

using namespace pointmill;

namespace {

/// 10 x 8 cells of 2 mm: the left half dense, the right half sparse, the top row empty.
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
      cell.z = r == 7 ? std::nanf("") : c < 5 ? 0.2f : 1.0f;
    }
  return map;
}

} // namespace

TEST(SpacingPicture, SparseIsPaleAndNothingIsGrey)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("map.png");
  writeSpacing(path, smallMap());
  const Picture picture(path);
  const int cell = 140 * 140, legend = 240 * 20; // px at most
  const Pixel worst{0xF3, 0xE6, 0xBE}, none{0xD3, 0xDA, 0xE1};
  EXPECT_NEAR(picture.count(worst), 35 * cell, legend);
  EXPECT_NEAR(picture.count(none), 10 * cell, legend);
  // 0.2 of 1.0 is the ramp's second colour.
  EXPECT_NEAR(picture.count(Pixel{0x2F, 0x6E, 0x93}), 35 * cell, legend);
  const int left = (picture.width() - 1400) / 2;
  EXPECT_EQ(picture.at(left + 1330, picture.height() / 2), worst);
}

TEST(SpacingPicture, RefusesMapsItCannotShow)
{
  const TemporaryFolder folder;
  EXPECT_THROW(writeSpacing(folder.file("map.png"), CellCloud()), DataError);
  CellCloud none = smallMap();
  for (auto& cell : none)
    cell.z = std::nanf("");
  EXPECT_THROW(writeSpacing(folder.file("map.png"), none), DataError);
  EXPECT_TRUE(folder.empty());
}
