// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/finding_picture.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace pointmill;

namespace {

const Pixel kRed{0xC8, 0x28, 0x1E}, kYellow{0xF0, 0xB4, 0x29}, kBlue{0x00, 0x72, 0xB2},
    kWhite{255, 255, 255};

// Of a picture of 1800 px: cards, and the plot of the first section within its card.
constexpr int kUnit = 9, kHalf = 900, kTop = 8 * kUnit, kFirstCard = 78 * kUnit,
              kPlotTop = 166, kPlotBottom = 738, kPlotLeft = 990, kPlotRight = 1755;

bool isDark(const Pixel& p)
{
  return p[0] + p[1] + p[2] < 240;
}
/// The tool over white or over material.
bool isTool(const Pixel& p)
{
  return p[0] > 190 && p[0] - p[2] > 70 && p[1] > 150;
}

/// A level plate of 40 x 30 mm with its top at 0.
struct Plate {
  Plate()
  {
    for (int y = 0; y <= 120; ++y)
      for (int x = 0; x <= 160; ++x)
        part.push_back(pcl::PointXYZ(0.25f * x, 0.25f * y, 0.f));
    milled.width = 80;
    milled.height = 60;
    for (int r = 0; r < 60; ++r)
      for (int c = 0; c < 80; ++c) {
        PointCell cell;
        cell.x = static_cast<float>(0.5 * c + 0.25);
        cell.y = static_cast<float>(0.5 * r + 0.25);
        cell.z = 0.f;
        milled.points.push_back(cell);
      }
    scene.title = "plate.pcd";
    scene.part = &part;
    scene.stock = {{0, 0, -10}, {40, 30, 2}};
  }
  /// @p tool stands @p depth deep in the plate, its tip @p away from a finding's place.
  FindingMark& sink(const Tool& tool, double depth, const Eigen::Vector2d& away)
  {
    FindingMark mark;
    mark.code = "gouge";
    mark.text = "the part is gouged";
    mark.where = "line 12";
    mark.tool = tool.number;
    mark.place = Eigen::Vector3d(20, 15, 0);
    mark.tip = Eigen::Vector3d(20 + away.x(), 15 + away.y(), -depth);
    scene.tools.push_back(tool);
    scene.findings.push_back(mark);
    return scene.findings.back();
  }
  Picture draw(const TemporaryFolder& folder, int width = 1800) const
  {
    writeFindings(folder.file("findings.png"), scene, width);
    return Picture(folder.file("findings.png"));
  }

  pcl::PointCloud<pcl::PointXYZ> part;
  CellCloud milled;
  FindingScene scene;
};

/// Red pixels of the part seen from above.
int redOnMap(const Picture& picture)
{
  return picture.count(
      0, kHalf, kTop, kTop + kFirstCard, [](const Pixel& p) { return p == kRed; });
}

/// The last row of the plot in which a column shows the tool; -1 where none does.
int lowestToolRow(const Picture& picture, int column)
{
  for (int y = kPlotBottom; y > kPlotTop; --y)
    if (isTool(picture.at(column, y)))
      return y;
  return -1;
}

} // namespace

TEST(FindingPicture, TheColourOfTheVerdictLeads)
{
  const TemporaryFolder folder;
  Plate plate;
  const auto verdict = [&] { return plate.draw(folder).at(40, 36); };
  EXPECT_EQ(verdict(), kBlue); // nothing found
  FindingMark& mark = plate.sink(Tool::ball(1, 6), 0.5, {0, 0});
  EXPECT_EQ(verdict(), kRed);
  mark.warning = true;
  EXPECT_EQ(verdict(), kYellow);
}

TEST(FindingPicture, ASectionShowsTheTrueOutlineWhereverItIsCut)
{
  // Without points and stock there is nothing that hides it.
  const TemporaryFolder folder;
  for (const Tool& tool : {Tool::ball(1, 6),
                           Tool::flat(1, 8),
                           Tool::bull(1, 8, 1.5),
                           Tool::taperBall(1, 2, 20, 6),
                           Tool::cone(1, 40, 6)})
    for (const double turn : {0.0, 0.4, 1.57, 2.4}) {
      Plate plate;
      plate.scene.part = nullptr;
      const double r = 0.2 * tool.radius();
      plate.sink(
          tool, tool.radius(), r * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
      const Picture picture = plate.draw(folder);
      const double scale = (kPlotRight - kPlotLeft) / (2.8 * tool.radius());
      const double axis = (kPlotLeft + kPlotRight) / 2.0 +
                          (std::cos(turn) < -0.01 ? -1 : 1) * r * scale;
      const double tip = (kPlotTop + kPlotBottom) / 2.0 + tool.radius() * scale;
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const double u = share * tool.radius();
        const double height = tool.profile(u) * scale;
        if (tip - height < kPlotTop + 10)
          continue; // out of sight
        // The length of the dimension may hide the outline on one side.
        const int row =
            std::max(lowestToolRow(picture, static_cast<int>(axis - u * scale)),
                     lowestToolRow(picture, static_cast<int>(axis + u * scale)));
        // A pixel aside is worth more where the outline is steep.
        const double steep =
            tool.profile(u + 1.5 / scale) * scale - tool.profile(u) * scale;
        EXPECT_NEAR(tip - row, height, 4 + steep)
            << tool.describe() << " turned " << turn << " at " << u;
      }
    }
}

TEST(FindingPicture, TheDimensionIsAsLongAsTheDepth)
{
  const TemporaryFolder folder;
  for (const double depth : {1.0, 1.5, 2.0}) {
    Plate plate;
    plate.scene.part = nullptr;
    plate.sink(Tool::flat(1, 10), depth, {0, 0});
    const Picture picture = plate.draw(folder);
    const double scale = (kPlotRight - kPlotLeft) / std::min(10 * depth, 14.0);
    const int middle = (kPlotLeft + kPlotRight) / 2;
    int first = 0, last = 0;
    for (int y = kPlotTop + 40; y < kPlotBottom - 40; ++y)
      if (isDark(picture.at(middle, y))) {
        first = first ? first : y;
        last = y;
      }
    // From the upper side of the ring to the lower side of the line at its end.
    EXPECT_NEAR(last - first, depth * scale + 0.8 * kUnit + 2, 4) << depth;
  }
}

TEST(FindingPicture, WhatIsNoDepthAtThePlaceGetsNoDimension)
{
  // The tool stands on what it left, under a layer that is gone.
  const TemporaryFolder folder;
  const auto dark = [&](double worst, const std::string& note) {
    Plate plate;
    plate.scene.part = nullptr;
    plate.scene.milled = &plate.milled;
    for (auto& cell : plate.milled)
      cell.z = -0.2f;
    FindingMark& mark = plate.sink(Tool::flat(1, 10), 0, {0, 0});
    mark.code = "axial_depth";
    mark.worst = worst;
    mark.note = note;
    return plate.draw(folder).count(
        kPlotLeft, kPlotRight, kPlotTop + 60, kPlotBottom - 60, isDark);
  };
  const int shown = dark(0.2, ""), none = dark(4.956, "");
  EXPECT_GT(shown, none + 300);
  EXPECT_GT(none, 50); // the place's ring
  // The words that are said instead take a line over the plot.
  EXPECT_NEAR(dark(4.956, "the layer is gone"), none, 30);
}

TEST(FindingPicture, TheEndOfTheToolIsInSight)
{
  // A small gouge high on the flank of a ball.
  const TemporaryFolder folder;
  Plate plate;
  plate.scene.part = nullptr;
  const double r = 3, away = r * std::sin(1.2), up = r * (1 - std::cos(1.2));
  FindingMark& mark = plate.sink(Tool::ball(1, 2 * r), up, {away - 0.02, 0});
  mark.worst = 0.02;
  const Picture picture = plate.draw(folder);
  int lowest = -1;
  for (int x = kPlotLeft; x < kPlotRight; ++x)
    lowest = std::max(lowest, lowestToolRow(picture, x));
  EXPECT_GT(lowest, kPlotTop + (kPlotBottom - kPlotTop) / 2);
  EXPECT_LT(lowest, kPlotBottom - 5);
  EXPECT_LT(lowestToolRow(picture, kPlotRight - 3), lowest); // beyond, it rises again
}

TEST(FindingPicture, OneCauseGetsOneSection)
{
  const TemporaryFolder folder;
  const auto height = [&](const char* first, const char* second, double apart) {
    Plate plate;
    for (const char* code : {first, second, "rapid_in_part", "keep_out"}) {
      FindingMark& mark = plate.sink(Tool::ball(1, 6), 0.5, {0, 0});
      plate.scene.tools.resize(1);
      mark.code = code;
      mark.place->x() += code == second ? apart : code == first ? 0 : 10;
      mark.where = "line " + std::to_string(plate.scene.findings.size() / 3);
      mark.tip->x() = mark.place->x();
    }
    plate.scene.findings[0].where = "line 7"; // points beside each other, on two lines
    return plate.draw(folder).height();
  };
  // Two sections and the list fill two rows, three take another for the list.
  EXPECT_EQ(height("gouge", "scan_gouge", 0.3), height("gouge", "gouge", 0));
  EXPECT_GT(height("gouge", "scan_gouge", 4), height("gouge", "scan_gouge", 0.3));
  EXPECT_GT(height("gouge", "gap", 0.3), height("gouge", "scan_gouge", 0.3));
}

TEST(FindingPicture, PointsInTheToolAreRed)
{
  const TemporaryFolder folder;
  const auto red = [&](double depth) {
    Plate plate;
    plate.sink(Tool::ball(1, 6), depth, {0, 0});
    return plate.draw(folder).count(
        kPlotLeft, kPlotRight, kPlotTop, kPlotBottom, [](const Pixel& p) {
          return p == kRed;
        });
  };
  EXPECT_EQ(red(-0.1), 0);
  EXPECT_GT(red(0.3), 100);
  EXPECT_GT(red(1.0), red(0.3));
}

TEST(FindingPicture, WithoutATipTheToolStandsWhereItsMoveIsDeepest)
{
  const TemporaryFolder folder;
  Plate given, found;
  given.sink(Tool::ball(1, 6), 0.75, {0, 0});
  FindingMark& mark = found.sink(Tool::ball(1, 6), 0.75, {0, 0});
  mark.tip.reset();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mark.move = {{nan, 15, 5}, {5, 15, -0.75}, {35, 15, -0.75}};
  const Picture a = given.draw(folder), b = found.draw(folder);
  int differ = 0;
  for (int y = kPlotTop; y < kPlotBottom; ++y)
    for (int x = kPlotLeft; x < kPlotRight; ++x)
      differ += a.at(x, y) != b.at(x, y);
  EXPECT_LT(differ, 20);
  mark.move.clear();
  mark.tip.reset();
  const Picture none = found.draw(folder);
  EXPECT_EQ(none.count(kPlotLeft, kPlotRight, kPlotTop, kPlotBottom, isTool), 0);
}

TEST(FindingPicture, WithoutAToolTheDepthIsThatOfTheMilledField)
{
  const TemporaryFolder folder;
  Plate plate;
  for (auto& cell : plate.milled)
    cell.z = -1.f;
  FindingMark& mark = plate.sink(Tool::ball(1, 6), 0, {0, 0});
  mark.tip.reset();
  const auto material = [&] {
    const Picture picture = plate.draw(folder);
    const Pixel grey{0xD5, 0xDC, 0xE3};
    int top = kPlotBottom;
    for (int y = kPlotBottom; y > kPlotTop; --y)
      if (picture.at(kPlotLeft + 40, y) == grey)
        top = y;
    return (kPlotTop + kPlotBottom) / 2 - top;
  };
  plate.scene.milled = &plate.milled;
  const double scale = (kPlotRight - kPlotLeft) / 8.4; // 2.8 radii of the tool
  EXPECT_NEAR(material(), -1.0 * scale, 12); // the text over the plot moves its middle
  for (auto& cell : plate.milled)
    cell.z = 1.f;
  EXPECT_NEAR(material(), 1.0 * scale, 12);
}

TEST(FindingPicture, EveryPlaceHasItsNumberEvenWhereAllAreOne)
{
  const TemporaryFolder folder;
  const auto red = [&](int count, bool apart) {
    Plate plate;
    plate.scene.part = nullptr;
    plate.scene.milled = &plate.milled;
    for (int i = 0; i < count; ++i) {
      FindingMark& mark = plate.sink(Tool::ball(1, 6), -1, {0, 0});
      mark.tip.reset();
      if (apart)
        mark.place = Eigen::Vector3d(2 + 7 * (i % 5), 3 + 5 * (i / 5), 0);
    }
    return redOnMap(plate.draw(folder));
  };
  const int one = red(1, false);
  EXPECT_GT(one, 300);
  // As many as where each has a place for itself; two digits cover more than one.
  EXPECT_NEAR(red(25, false), red(25, true), one / 2.0);
  EXPECT_GT(red(25, false), 18 * one);
}

TEST(FindingPicture, APlaceFarAwayDoesNotShrinkThePart)
{
  const TemporaryFolder folder;
  Plate near, far;
  near.sink(Tool::ball(1, 6), 0.5, {0, 0});
  far.sink(Tool::ball(1, 6), 0.5, {0, 0}).place = Eigen::Vector3d(90000, 15, 0);
  far.scene.findings[0].move = {{-1e7, 15, 0}, {1e7, 15, 0}};
  const auto ground = [&](const Plate& plate) {
    return plate.draw(folder).count(
        0, kHalf, kTop, kTop + kFirstCard, [](const Pixel& p) {
          return p[2] > p[0] + 30;
        });
  };
  const int seen = ground(near);
  EXPECT_GT(seen, 100000);
  EXPECT_NEAR(ground(far), seen, seen / 20);
  EXPECT_GT(redOnMap(far.draw(folder)), 300); // its number stands at the rim
}

TEST(FindingPicture, AHolderHasItsWidth)
{
  // Of a holder of 20 mm on a tool of 6 mm, 1 mm deep beside the tool.
  const TemporaryFolder folder;
  Plate plate;
  plate.scene.part = nullptr;
  Tool tool = Tool::ball(1, 6);
  tool.flute_length = 8;
  tool.shank_diameter = 6;
  tool.stick_out = 12;
  tool.holder_diameter = 20;
  FindingMark& mark = plate.sink(tool, 13, {-8, 0});
  mark.worst = 1;
  const Picture picture = plate.draw(folder);
  const double scale = (kPlotRight - kPlotLeft) / 8.4;
  const int middle = (kPlotLeft + kPlotRight) / 2;
  int right = 0, bottom = 0;
  const auto isHolder = [](const Pixel& p) {
    return p[0] - p[2] < 30 && p[0] - p[2] > 8 && p[0] < 200 && p[0] > 120;
  };
  for (int x = middle; x < kPlotRight; ++x)
    if (isHolder(picture.at(x, kPlotTop + 20)))
      right = x;
  for (int y = kPlotTop; y < kPlotBottom; ++y)
    if (isHolder(picture.at(kPlotLeft + 30, y)))
      bottom = y;
  EXPECT_NEAR(right - middle, 2 * scale, 4); // 10 mm from an axis 8 mm away
  EXPECT_NEAR(bottom - (kPlotTop + kPlotBottom) / 2, 1 * scale, 12);
}

TEST(FindingPicture, IsHighEnoughForEveryFinding)
{
  const TemporaryFolder folder;
  Plate plate;
  int last = 0;
  for (const int count : {3, 13, 25, 60}) {
    while (static_cast<int>(plate.scene.findings.size()) < count) {
      FindingMark& mark = plate.sink(Tool::ball(1, 6), 0.5, {0, 0});
      mark.place.reset();
      mark.warning = plate.scene.findings.size() % 2;
      mark.code = std::string(90, 'c');
      mark.text = "\xFF\n$x$ | B\xC3\xBCste " + std::string(90, 'w') + " and more";
      mark.where = std::string(90, 'p');
    }
    const Picture picture = plate.draw(folder);
    EXPECT_GT(picture.height(), last);
    last = picture.height();
    // All that is drawn keeps clear of the picture's edge.
    for (int y = 0; y < picture.height(); ++y) {
      ASSERT_EQ(picture.at(20, y), kWhite);
      ASSERT_EQ(picture.at(picture.width() - 20, y), kWhite);
    }
    for (int x = 0; x < picture.width(); ++x) {
      ASSERT_EQ(picture.at(x, 0), kWhite);
      ASSERT_EQ(picture.at(x, picture.height() - 1), kWhite);
    }
  }
  plate.scene.findings.resize(1000, plate.scene.findings[0]);
  EXPECT_LT(plate.draw(folder).height(), last + 6 * kUnit); // and says how many more
}

TEST(FindingPicture, TakesWhateverTheSceneHolds)
{
  const TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  FindingScene scene;
  writeFindings(folder.file("a.png"), scene, 1000);
  scene.findings.resize(4);
  scene.findings[1].place = Eigen::Vector3d(nan, 0, 0);
  scene.findings[2].place = Eigen::Vector3d(1, 2, 3);
  scene.findings[2].tool = 7; // which the scene does not have
  scene.findings[2].tip = Eigen::Vector3d(1, 2, 3);
  scene.findings[3].place = Eigen::Vector3d(1, 2, 5);
  writeFindings(folder.file("a.png"), scene, 1000);
  pcl::PointCloud<pcl::PointXYZ> part;
  part.push_back(pcl::PointXYZ(std::nanf(""), 0.f, 0.f));
  scene.part = &part;
  writeFindings(folder.file("a.png"), scene, 1000);
  part.push_back(pcl::PointXYZ(1, 2, 3));
  writeFindings(folder.file("a.png"), scene, 1000);
  scene.tools = {Tool::ball(7, 6)};
  scene.findings[2].tip = Eigen::Vector3d(nan, 2, 3);
  scene.findings[2].move = {{nan, nan, nan}};
  writeFindings(folder.file("a.png"), scene, 1000);
  EXPECT_EQ(Picture(folder.file("a.png")).width(), 1000);
  EXPECT_EQ(folder.files(), 1u);
}

TEST(FindingPicture, IsTheSameEveryTime)
{
  const TemporaryFolder folder;
  Plate plate;
  plate.scene.milled = &plate.milled;
  plate.sink(Tool::ball(1, 6), 0.5, {0.3, 0.2});
  writeFindings(folder.file("a.png"), plate.scene, 1000);
  writeFindings(folder.file("b.png"), plate.scene, 1000);
  EXPECT_FALSE(readBytes(folder.file("a.png")).empty());
  EXPECT_EQ(readBytes(folder.file("a.png")), readBytes(folder.file("b.png")));
}

TEST(FindingPicture, RefusesWhatItCannotShow)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.png");
  Plate plate;
  EXPECT_THROW(writeFindings(path, plate.scene, 999), ParameterError);
  EXPECT_THROW(writeFindings(path, plate.scene, 3001), ParameterError);
  EXPECT_THROW(writeFindings(folder.file("no/such.png"), plate.scene), DataError);
  plate.milled.width = 4800;
  plate.milled.height = 1;
  plate.scene.milled = &plate.milled;
  EXPECT_THROW(writeFindings(path, plate.scene), DataError);
  plate.scene.milled = nullptr;
  plate.scene.tools = {Tool::flat(1, -4)};
  EXPECT_THROW(writeFindings(path, plate.scene), ParameterError);
  EXPECT_TRUE(folder.empty());
}
