// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Pictures are judged by what is where: drivers differ in single pixels.
#include "picture.h"
#include "viewer_test.h"

#include <pointmill/common/error.h>
#include <pointmill/viewer/add_cloud.h>
#include <pointmill/viewer/program_path.h>
#include <pointmill/viewer/viewer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace viewer_test;

namespace {

constexpr int kWidth = 640, kHeight = 480;

bool isBackground(const Pixel& p)
{
  return p[0] > 250 && p[1] > 250 && p[2] > 250;
}

/// The hue of a palette's colour, whatever light falls on it.
bool isBlue(const Pixel& p)
{
  return p[2] > p[0] + 30 && p[2] > p[1];
}
bool isOrange(const Pixel& p)
{
  return p[0] > p[2] + 40 && p[1] > p[2] + 15 && p[0] > p[1];
}
bool isRed(const Pixel& p)
{
  return p[0] > 120 && p[0] > p[1] + 60 && p[0] > p[2] + 60;
}
bool isYellow(const Pixel& p)
{
  return p[0] > 150 && p[1] > 130 && p[2] < p[1] - 60 && std::abs(p[0] - p[1]) < 60;
}

ViewerScene scene()
{
  ViewerScene s;
  s.title = "block";
  s.stock = block();
  s.player = playerOf(twoCuts());
  s.sections = {{"slot", 0}, {"groove", 1}};
  return s;
}

/// Nothing but the solid, from above.
ViewerLook bare()
{
  ViewerLook look;
  look.paths = ViewedPaths::None;
  look.from = ViewedFrom::Top;
  look.tool = look.box = look.texts = false;
  look.axes = -1;
  return look;
}

class Pictures : public testing::Test {
protected:
  /// Draws, and reads what was drawn.
  Picture draw(ViewerScene s, const ViewerLook& look)
  {
    Viewer(std::move(s), look).screenshot(folder_.file("view.png"), kWidth, kHeight);
    return Picture(folder_.file("view.png"));
  }
  template <typename Test>
  static int all(const Picture& p, const Test& test)
  {
    return p.count(0, p.width(), 0, p.height(), test);
  }
  TemporaryFolder folder_;
};

/// The pixels that are not the background: their box.
struct Extent {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
  explicit Extent(const Picture& p)
  {
    for (int y = 0; y < p.height(); ++y)
      for (int x = 0; x < p.width(); ++x)
        if (!isBackground(p.at(x, y))) {
          left = std::min(left, x);
          right = std::max(right, x);
          top = std::min(top, y);
          bottom = std::max(bottom, y);
        }
  }
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

} // namespace

TEST_F(Pictures, NeedNoDisplay)
{
  unsetenv("DISPLAY");
  const Picture p = draw(scene(), bare());
  EXPECT_EQ(p.width(), kWidth);
  EXPECT_EQ(p.height(), kHeight);
  EXPECT_EQ(folder_.files(), 1u);
}

TEST_F(Pictures, TheStockLiesInTheMiddleAsWideAsItIs)
{
  const Picture p = draw(scene(), bare());
  const Extent e(p);
  EXPECT_NEAR((e.left + e.right) / 2.0, kWidth / 2.0, 4);
  EXPECT_NEAR((e.top + e.bottom) / 2.0, kHeight / 2.0, 4);
  EXPECT_NEAR(double(e.width()) / e.height(), 40.0 / 30.0, 0.03);
  EXPECT_GT(e.width(), kWidth / 3);
  // Nothing is cut yet: one colour.
  EXPECT_EQ(all(p, isBlue), 0);
  EXPECT_EQ(all(p, isOrange), 0);
}

TEST_F(Pictures, WhatIsCutHasTheColourOfItsOperationWhereItIs)
{
  ViewerScene s = scene();
  ViewerLook look = bare();
  look.time = s.player->duration();
  const Picture p = draw(std::move(s), look);
  const Extent e(p);
  const auto at = [&](double x, double y) { // places of the block [mm], from above
    return p.at(e.left + static_cast<int>(x / 40 * e.width()),
                e.bottom - static_cast<int>(y / 30 * e.height()));
  };
  EXPECT_TRUE(isBlue(at(10, 15)));
  EXPECT_TRUE(isOrange(at(30, 5)));
  EXPECT_TRUE(isOrange(at(30, 25)));
  EXPECT_FALSE(isBlue(at(10, 5)));
  EXPECT_FALSE(isOrange(at(10, 25)));
}

TEST_F(Pictures, OnTheWayOnlyWhatIsBehindTheToolIsCut)
{
  ViewerScene s = scene();
  const std::size_t slot = s.player->moveOfLine(9);
  ViewerLook look = bare();
  look.time = (s.player->beginOf(slot) + s.player->endOf(slot)) / 2;
  const Picture p = draw(std::move(s), look);
  const Extent e(p);
  const auto blueIn = [&](double x0, double x1) {
    return p.count(e.left + static_cast<int>(x0 / 40 * e.width()),
                   e.left + static_cast<int>(x1 / 40 * e.width()),
                   e.top,
                   e.bottom,
                   isBlue);
  };
  EXPECT_GT(blueIn(2, 18), 200);
  EXPECT_EQ(blueIn(25, 39), 0);
}

TEST_F(Pictures, TheToolStandsAtItsPlace)
{
  ViewerScene s = scene();
  const std::size_t slot = s.player->moveOfLine(9);
  ViewerLook look = bare();
  look.solid = ViewedSolid::None;
  look.from = ViewedFrom::Front;
  look.tool = true;
  look.time = (s.player->beginOf(slot) + s.player->endOf(slot)) / 2; // at X20
  const Picture p = draw(std::move(s), look);
  const Extent e(p);
  EXPECT_NEAR((e.left + e.right) / 2.0, kWidth / 2.0, 4);
  EXPECT_GT(e.height(), 2 * e.width()); // upright
}

TEST_F(Pictures, PathsHaveTheColoursThatWereAskedFor)
{
  ViewerScene s;
  s.stock = block();
  auto path = std::make_shared<CLCloud>();
  for (int i = 0; i <= 40; ++i)
    path->push_back(PointCL(i, 5, 0, Motion::Cut));
  for (int i = 0; i <= 40; ++i)
    path->push_back(PointCL(40 - i, 25, 0, i == 0 ? Motion::Rapid : Motion::Cut));
  for (auto& p : *path)
    p.feed = 500;
  s.path = path;
  s.operations = {{"one", 0, 0, 41}, {"two", 1, 41, 41}};
  ViewerLook look = bare();
  look.paths = ViewedPaths::All;
  look.rapids = false;
  const Picture p = draw(s, look);
  const Extent e(p);
  // Two lines: the first operation's is the lower one.
  EXPECT_GT(p.count(0, kWidth, e.bottom - 3, e.bottom + 1, isBlue), 100);
  EXPECT_GT(p.count(0, kWidth, e.top, e.top + 4, isOrange), 100);
  EXPECT_EQ(p.count(0, kWidth, e.top + 6, e.bottom - 6, isBlue), 0);
  look.colouring = PathColouring::Motion;
  EXPECT_EQ(all(draw(s, look), isOrange), 0); // both are cuts
}

TEST_F(Pictures, RapidsAreDashed)
{
  ViewerScene s;
  s.stock = block();
  auto path = std::make_shared<CLCloud>();
  path->push_back(PointCL(0, 15, 0, Motion::Cut));
  path->push_back(PointCL(40, 15, 0, Motion::Rapid));
  s.path = path;
  s.operations = {{"one", 0, 0, 2}};
  ViewerLook look = bare();
  look.paths = ViewedPaths::All;
  const Picture p = draw(s, look);
  const Extent e(p);
  int pieces = 0;
  bool ink = false;
  for (int x = e.left; x <= e.right; ++x) {
    const bool now = p.count(x, x + 1, e.top, e.bottom + 1, [](const Pixel& c) {
      return c[0] < 200;
    }) > 0;
    pieces += now && !ink;
    ink = now;
  }
  EXPECT_GT(pieces, 10);
}

TEST_F(Pictures, TheMapIsRedYellowAndBlueGreyWhereItIs)
{
  ViewerScene s;
  auto map = std::make_shared<CellCloud>(30, 20);
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 30; ++c) {
      PointCell& cell = map->at(c, r);
      cell.x = static_cast<float>(c);
      cell.y = static_cast<float>(r);
      cell.z = c < 10 ? 0.f : -10.f;
      cell.setState(c < 20 ? CellState::Occupied : CellState::Gap);
      if (c >= 20)
        cell.z = 0;
    }
  s.map = map;
  ViewerLook look = bare();
  look.map = true;
  look.level = 9;
  const Picture p = draw(s, look);
  const Extent e(p);
  const int y = (e.top + e.bottom) / 2;
  const auto at = [&](double share) {
    return p.at(e.left + static_cast<int>(share * e.width()), y);
  };
  EXPECT_TRUE(isRed(at(0.15)));
  EXPECT_TRUE(isYellow(at(0.5)));
  EXPECT_TRUE(isBlue(at(0.85)));
}

TEST_F(Pictures, DeviationsAreBlueWhereMaterialIsLeftAndRedWhereItIsGone)
{
  ViewerScene s;
  s.stock = block();
  auto points = std::make_shared<pcl::PointCloud<pcl::PointXYZI>>();
  for (int i = 0; i < 400; ++i)
    for (int k = 0; k < 300; ++k) {
      pcl::PointXYZI p;
      p.x = 0.1f * static_cast<float>(i);
      p.y = 0.1f * static_cast<float>(k);
      p.z = 0;
      p.intensity = i < 200 ? 0.3f : -0.3f;
      points->push_back(p);
    }
  s.deviation = points;
  ViewerLook look = bare();
  look.solid = ViewedSolid::Deviation;
  const Picture p = draw(s, look);
  EXPECT_GT(p.count(0, kWidth / 2, 0, kHeight, isBlue), 10000);
  EXPECT_EQ(p.count(kWidth / 2 + 4, kWidth, 0, kHeight, isBlue), 0);
  EXPECT_GT(p.count(kWidth / 2, kWidth, 0, kHeight, isRed), 10000);
}

TEST_F(Pictures, CloudsAreShownWithAllTheirFields)
{
  ViewerScene s;
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 200; ++k) {
      pcl::PointXYZRGB p;
      p.r = 200;
      p.x = static_cast<float>(i);
      p.y = static_cast<float>(k);
      p.z = 0;
      cloud.push_back(p);
    }
  pcl::PCLPointCloud2::Ptr blob(new pcl::PCLPointCloud2);
  pcl::toPCLPointCloud2(cloud, *blob);
  s.clouds.push_back({"red.pcd", blob});
  ViewerLook look = bare();
  EXPECT_GT(all(draw(s, look), [](const Pixel& p) { return !isBackground(p); }), 10000);
}

TEST_F(Pictures, CloudsOfOneNameAreAllShownAndPointsWithoutAPlaceAreNot)
{
  const auto square = [](float x0) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (int i = 0; i < 100; ++i)
      for (int k = 0; k < 100; ++k)
        cloud.push_back({x0 + static_cast<float>(i), static_cast<float>(k), 0.f});
    cloud.push_back({std::numeric_limits<float>::quiet_NaN(), 50, 5000});
    pcl::PCLPointCloud2::Ptr blob(new pcl::PCLPointCloud2);
    pcl::toPCLPointCloud2(cloud, *blob);
    return blob;
  };
  ViewerScene s;
  addCloud(s, "scan.pcd", square(0));
  addCloud(s, "scan.pcd", square(200));
  const Picture p = draw(s, bare());
  const Extent e(p);
  EXPECT_NEAR(double(e.width()) / e.height(), 3.0, 0.1); // both, and nothing else
  EXPECT_GT(p.count(0, kWidth / 2, 0, kHeight, isBlue), 1000);
  EXPECT_GT(p.count(kWidth / 2, kWidth, 0, kHeight, isOrange), 1000);
}

TEST_F(Pictures, AProgramWithoutClPointsHasThoseOfItsMoves)
{
  ViewerScene s = scene();
  addProgramPath(s);
  ASSERT_EQ(s.operations.size(), 2u);
  EXPECT_EQ(s.operations[0].name, "slot");
  EXPECT_EQ(s.operations[0].count + s.operations[1].count, s.path->size());
  ViewerLook look = bare();
  look.paths = ViewedPaths::All;
  look.solid = ViewedSolid::None;
  look.rapids = false;
  const Picture p = draw(std::move(s), look);
  EXPECT_GT(all(p, isBlue), 100);
  EXPECT_GT(all(p, isOrange), 100);
}

TEST_F(Pictures, TextsStandAtTheSidesAndCanBeLeftOut)
{
  ViewerScene s = scene();
  s.operations = {{"slot, T1 flat 6 mm", 0, 0, 0}, {"groove, T2 ball 4 mm", 1, 0, 0}};
  ViewerLook look = bare();
  look.solid = ViewedSolid::None;
  const auto dark = [](const Pixel& p) {
    return p[0] < 110 && p[1] < 110 && p[2] < 120;
  };
  EXPECT_EQ(draw(s, look).count(0, kWidth / 4, 0, 40, dark), 0);
  look.solid = ViewedSolid::Stock;
  look.texts = true;
  const Picture p = draw(s, look);
  EXPECT_GT(p.count(0, kWidth / 4, 0, 40, dark), 20);                 // title
  EXPECT_GT(p.count(2 * kWidth / 3, kWidth, 0, 120, dark), 60);       // legend
  EXPECT_GT(p.count(0, kWidth / 2, kHeight - 60, kHeight, dark), 60); // moment
  // Nothing is cut off at the edges.
  for (const int x : {0, kWidth - 1})
    EXPECT_EQ(p.count(x, x + 1, 0, kHeight, dark), 0);
}

TEST_F(Pictures, FindingsAreMarkedAndLookedAtFromNearBy)
{
  ViewerScene s = scene();
  s.findings = {{"error gouge", true, 9, Eigen::Vector3d(5, 5, 0)}};
  ViewerLook look = bare();
  const int far = all(draw(s, look), isRed);
  EXPECT_GT(far, 5);
  look.finding = 0;
  const Picture p = draw(s, look);
  EXPECT_GT(all(p, isRed), 2 * far);
  EXPECT_TRUE(isRed(p.at(kWidth / 2, kHeight / 2))); // in the middle
}

TEST_F(Pictures, NonsenseIsRefusedAndLeavesNothing)
{
  EXPECT_THROW(Viewer(scene(), bare()).screenshot(folder_.file("a.png"), 10, 480),
               ParameterError);
  EXPECT_THROW(Viewer(scene(), bare()).screenshot(folder_.file("no/a.png"), 640, 480),
               DataError);
  EXPECT_TRUE(folder_.empty());
}
