// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Heights, curvature, gaps and levels, by what is where in the pictures.
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/curvature_picture.h>
#include <pointmill/visual/gaps_picture.h>
#include <pointmill/visual/heights_picture.h>
#include <pointmill/visual/levels_picture.h>

#include <cmath>
#include <functional>

using namespace pointmill;

namespace {

constexpr int kLeft = 36, kTop = 84; // px, of the cells
const Pixel kInkPixel{0x1F, 0x29, 0x33}, kGrey{0xD3, 0xDA, 0xE1};
const Pixel kRed{0xC8, 0x28, 0x1E}, kYellow{0xF6, 0xD7, 0x43}, kBlue{0x5B, 0x7C, 0x99};

/// 20 x 10 cells of 2 mm, 70 px each in the pictures.
CellCloud mapOf(const std::function<double(int, int)>& z)
{
  CellCloud map;
  map.resize(200);
  map.width = 20;
  map.height = 10;
  for (int r = 0; r < 10; ++r)
    for (int c = 0; c < 20; ++c) {
      PointCell& cell = map.at(c, r);
      cell.x = static_cast<float>(2 * c + 1);
      cell.y = static_cast<float>(2 * r + 1);
      cell.z = static_cast<float>(z(c, r));
      cell.setState(std::isfinite(cell.z) ? CellState::Occupied : CellState::Empty);
    }
  return map;
}

int middleX(int column)
{
  return kLeft + 70 * column + 35;
}
int middleY(int row)
{
  return kTop + 70 * (9 - row) + 35;
}

int brightness(const Pixel& p)
{
  return p[0] + p[1] + p[2];
}

/// Length of the scale bar [px], in the first line under the cells: 10 mm at 35 px/mm
/// would be 350, so it is 5 mm.
int scaleBar(const Picture& picture)
{
  const int y = kTop + 700 + 36;
  int longest = 0;
  for (int row = y - 2; row <= y + 2; ++row) {
    int length = 0;
    while (picture.at(kLeft + length, row) == kInkPixel)
      ++length;
    longest = std::max(longest, length);
  }
  return longest;
}

int share(const Picture& picture, int column, int row, const Pixel& colour)
{
  const int x = kLeft + 70 * column, y = kTop + 70 * (9 - row);
  return 100 * picture.count(x, x + 70, y, y + 70, [&](const Pixel& p) {
    return p == colour;
  }) / 4900;
}

GapRegion gapAt(int column, int row, GapPolicy treatment, GapKind kind)
{
  GapRegion gap;
  gap.area = 4 * 4.0;
  for (const int r : {row, row + 1})
    for (const int c : {column, column + 1})
      gap.cells.push_back(static_cast<std::size_t>(r) * 20 + c);
  gap.treatment = treatment;
  gap.kind = kind;
  return gap;
}

} // namespace

TEST(HeightsPicture, HighIsPaleAndNothingIsGrey)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("heights.png");
  writeHeights(path, mapOf([](int c, int r) {
                 return r == 9 ? std::nan("") : c < 10 ? -20.0 : 0.0;
               }));
  const Picture picture(path);
  const Pixel low = picture.at(middleX(3), middleY(4));
  const Pixel high = picture.at(middleX(16), middleY(4));
  EXPECT_EQ(low, (Pixel{0x21, 0x46, 0x6E}));
  EXPECT_EQ(high, (Pixel{0xF3, 0xE6, 0xBE}));
  EXPECT_EQ(picture.at(middleX(3), middleY(9)), kGrey);
  EXPECT_NEAR(scaleBar(picture), 5 * 35, 3);
  // Both ends of the bar are under the map.
  const auto below = [&](const Pixel& p) {
    return picture.count(
        0, picture.width(), kTop + 700, picture.height(), [&](const Pixel& q) {
          return std::abs(p[0] - q[0]) < 6 && std::abs(p[1] - q[1]) < 6 &&
                 std::abs(p[2] - q[2]) < 6; // the ends themselves have ticks
        });
  };
  EXPECT_GT(below(low), 10);
  EXPECT_GT(below(high), 10);
}

TEST(HeightsPicture, TheColoursEndAtTheLowestAndHighestButForStrays)
{
  const TemporaryFolder folder;
  const auto colours = [&](double lowest) {
    CellCloud map;
    map.width = map.height = 100;
    for (int r = 0; r < 100; ++r)
      for (int c = 0; c < 100; ++c) {
        PointCell cell;
        cell.x = static_cast<float>(c);
        cell.y = static_cast<float>(r);
        cell.z = c < 50 ? -20.f : 0.f;
        map.points.push_back(cell);
      }
    for (int c = 20; c < 30; ++c) // a thousandth of the cells
      map.points[std::size_t(5000 + c)].z = static_cast<float>(lowest);
    writeHeights(folder.file("h.png"), map);
    const Picture picture(folder.file("h.png"));
    return picture.at(36 + 14 * 10 + 7, 84 + 14 * 10 + 7);
  };
  const Pixel darkest{0x21, 0x46, 0x6E};
  EXPECT_EQ(colours(-20), darkest);
  EXPECT_NE(colours(-21.5), darkest); // the groove is
  EXPECT_EQ(colours(-500), darkest);  // a stray takes no colour
}

TEST(HeightsPicture, SlopesAreLitFromTheUpperLeft)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("heights.png");
  writeHeights(path, mapOf([](int c, int) { return c < 10 ? c : 19.0 - c; }));
  const Picture picture(path);
  // Of one height on both sides of the ridge.
  EXPECT_GT(brightness(picture.at(middleX(5), middleY(5))),
            brightness(picture.at(middleX(14), middleY(5))) + 60);
}

TEST(HeightsPicture, TheSameFieldGivesTheSameBytes)
{
  const TemporaryFolder folder;
  const CellCloud map = mapOf([](int c, int r) { return std::sin(c) + r; });
  writeHeights(folder.file("a.png"), map);
  writeHeights(folder.file("b.png"), map);
  EXPECT_EQ(readBytes(folder.file("a.png")), readBytes(folder.file("b.png")));
}

TEST(HeightsPicture, RefusesFieldsItCannotShow)
{
  const TemporaryFolder folder;
  EXPECT_THROW(writeHeights(folder.file("a.png"), CellCloud()), DataError);
  EXPECT_THROW(
      writeHeights(folder.file("a.png"), mapOf([](int, int) { return std::nan(""); })),
      DataError);
  EXPECT_TRUE(folder.empty());
}

TEST(CurvaturePicture, HollowsAreBrownRidgesBlueAndTooTightOnesHatched)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("curvature.png");
  // A ridge, flat ground, hollows of R 10, R 2 and R 1, and nothing.
  const double hollows[] = {-0.5, 0.0, 0.1, 0.5, 1.0};
  const auto hollow =
      mapOf([&](int c, int r) { return r == 0 ? std::nan("") : hollows[c / 4]; });
  const auto ridge = mapOf([&](int c, int r) {
    return r == 0 ? std::nan("") : std::min(0.0, hollows[c / 4]);
  });
  writeCurvature(
      path, hollow, ridge, {Tool::flat(1, 10), Tool::ball(2, 5), Tool::ball(3, 3)});
  const Picture picture(path);
  const auto at = [&](int c) { return picture.at(middleX(c), middleY(5)); };
  EXPECT_GT(at(1)[2], at(1)[0] + 40); // blue
  EXPECT_EQ(at(5), (Pixel{0xF7, 0xF4, 0xEC}));
  EXPECT_GT(at(9)[0], at(9)[2] + 10); // brown, that both balls get into
  EXPECT_LT(brightness(at(13)), brightness(at(9)) - 100); // only the smaller one
  EXPECT_EQ(picture.at(middleX(9), middleY(0)), kGrey);
  const Pixel tight{0x5C, 0x30, 0x06}, line{0xF3, 0xD9, 0xAE};
  EXPECT_NEAR(share(picture, 17, 5, tight), 75, 3);
  EXPECT_NEAR(share(picture, 17, 5, line), 25, 3);
  EXPECT_EQ(share(picture, 13, 5, line), 0);
  EXPECT_NEAR(scaleBar(picture), 5 * 35, 3);
}

TEST(CurvaturePicture, WithoutBallsNothingIsTooTight)
{
  const TemporaryFolder folder;
  const auto hollow = mapOf([](int c, int) { return 0.1 * c; });
  const auto ridge = mapOf([](int, int) { return -0.01; });
  writeCurvature(folder.file("a.png"), hollow, ridge, {Tool::flat(1, 10)});
  const Picture picture(folder.file("a.png"));
  EXPECT_GT(brightness(picture.at(middleX(2), middleY(5))),
            brightness(picture.at(middleX(19), middleY(5))));
  EXPECT_THROW(writeCurvature(folder.file("b.png"), hollow, CellCloud(), {}),
               DataError);
}

TEST(GapsPicture, EachGapIsHatchedAndOutlinedAfterItsTreatment)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("gaps.png");
  const auto map = mapOf([](int, int) { return 0.0; });
  writeGaps(path,
            map,
            {gapAt(2, 4, GapPolicy::Bridge, GapKind::NotScanned),
             gapAt(8, 4, GapPolicy::Keep, GapKind::NotScanned),
             gapAt(14, 4, GapPolicy::Mill, GapKind::ThroughHole)});
  const Picture picture(path);
  const Pixel line{0xD5, 0xDF, 0xE8};
  // Lower left cells: the number is in the middle, or beside.
  EXPECT_NEAR(share(picture, 2, 4, line), 23, 7);
  EXPECT_NEAR(share(picture, 8, 4, line), 41, 9);
  EXPECT_GT(share(picture, 14, 4, kYellow), 60);
  EXPECT_GT(share(picture, 2, 4, kBlue), 50);
  // The outline lies outside of the cells.
  const int y = middleY(4);
  EXPECT_EQ(picture.at(kLeft + 2 * 70 - 2, y), kInkPixel);
  EXPECT_EQ(picture.at(kLeft + 4 * 70 + 1, y), kInkPixel);
  EXPECT_EQ(picture.at(middleX(2), kTop + 70 * 6 + 1), kInkPixel);
  EXPECT_NE(picture.at(kLeft + 3 * 70 - 2, y), kInkPixel); // none between its own cells
  EXPECT_NEAR(scaleBar(picture), 5 * 35, 3);
  // The list shows each pattern again.
  const auto below = [&](const Pixel& p) {
    return picture.count(
        0, picture.width(), kTop + 700 + 60, picture.height(), [&](const Pixel& q) {
          return p == q;
        });
  };
  EXPECT_GT(below(kBlue), 500);
  EXPECT_GT(below(kYellow), 300);
}

TEST(GapsPicture, WhatIsBridgedBetweenPointsIsShownWithoutAnyGapToo)
{
  const TemporaryFolder folder;
  auto map = mapOf([](int, int r) { return r < 5 ? std::nan("") : 0.0; });
  for (int r = 5; r < 10; ++r)
    for (int c = 0; c < 20; ++c)
      map.at(c, r).setState(c < 10 ? CellState::Between : CellState::Occupied);
  writeGaps(folder.file("gaps.png"), map, {});
  const Picture picture(folder.file("gaps.png"));
  const Pixel ground{0xF6, 0xE3, 0xEE}, ink{0xD9, 0xA5, 0xC4};
  EXPECT_GT(share(picture, 3, 7, ground), 60);
  EXPECT_GT(share(picture, 3, 7, ink), 15);
  EXPECT_EQ(share(picture, 13, 7, ground), 0);
  const auto below = [&](const Pixel& p) {
    return picture.count(
        0, picture.width(), kTop + 700 + 60, picture.height(), [&](const Pixel& q) {
          return p == q;
        });
  };
  EXPECT_GT(below(ground), 300);
  EXPECT_GT(below(ink), 80);
  // A line more says what white is.
  for (auto& cell : map)
    if (cell.getState() == CellState::Empty)
      cell.setState(CellState::Occupied);
  writeGaps(folder.file("all.png"), map, {});
  EXPECT_EQ(picture.height(), Picture(folder.file("all.png")).height() + 32);
}

TEST(GapsPicture, OfManyTheLargestAreListed)
{
  const TemporaryFolder folder;
  const auto map = mapOf([](int, int) { return 0.0; });
  std::vector<GapRegion> gaps(40, gapAt(2, 4, GapPolicy::Bridge, GapKind::NotScanned));
  writeGaps(folder.file("many.png"), map, gaps);
  const int many = Picture(folder.file("many.png")).height();
  gaps.resize(24);
  writeGaps(folder.file("some.png"), map, gaps);
  EXPECT_EQ(many, Picture(folder.file("some.png")).height() + 32); // "and 16 smaller"
  EXPECT_THROW(writeGaps(folder.file("none.png"), map, {}), DataError);
}

TEST(LevelsPicture, EachLevelIsATileOfTheSameSize)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("levels.png");
  // Stairs: at the k-th level k of four steps stand above.
  const auto map = mapOf([](int c, int) { return -1.0 - c / 5; });
  writeLevels(path, map, {-1.5, -2.5, -3.5, -4.5});
  const Picture picture(path);
  const int red = picture.count(kRed), yellow = picture.count(kYellow);
  EXPECT_NEAR(double(red) / (red + yellow), (1 + 2 + 3 + 4) / 16.0, 0.02);
}

TEST(LevelsPicture, OfManyLevelsSomeAreShown)
{
  const TemporaryFolder folder;
  const auto map = mapOf([](int c, int) { return -1.0 * c; });
  std::vector<double> levels;
  for (int i = 0; i < 200; ++i)
    levels.push_back(-0.1 * i);
  writeLevels(folder.file("levels.png"), map, levels);
  EXPECT_LT(Picture(folder.file("levels.png")).height(), 2000);
  EXPECT_THROW(writeLevels(folder.file("none.png"), map, {}), DataError);
  EXPECT_THROW(writeLevels(folder.file("none.png"), CellCloud(), levels), DataError);
  EXPECT_EQ(folder.files(), 1u);
}
