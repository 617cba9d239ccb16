// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "levels.h"
#include "playback.h"
#include "viewer_test.h"

#include <gtest/gtest.h>

using namespace viewer_test;
using viewer::changeLook;

namespace {

ViewerScene scene()
{
  ViewerScene s;
  s.stock = block();
  s.player = playerOf(twoCuts(), 0.5);
  s.findings = {{"error gouge: 0.2 mm", true, 9, Eigen::Vector3d(20, 15, -4)},
                {"warning idle", false, 0, {}}};
  return s;
}

ViewerLook after(std::initializer_list<const char*> keys, const ViewerScene& s)
{
  ViewerLook look;
  for (const char* key : keys) {
    EXPECT_TRUE(changeLook(key, false, s, {0, -1, -2}, look)) << key;
    s.player->seek(look.time);
  }
  return look;
}

} // namespace

TEST(Playback, KeysGoThroughAllSurfacesAndBack)
{
  const auto s = scene();
  EXPECT_EQ(after({"v"}, s).solid, ViewedSolid::Part);
  EXPECT_EQ(after({"v", "V"}, s).solid, ViewedSolid::Deviation);
  EXPECT_EQ(after({"v", "v", "v", "v"}, s).solid, ViewedSolid::Stock);
  ViewerLook look;
  changeLook("v", true, s, {}, look); // with Shift
  EXPECT_EQ(look.solid, ViewedSolid::None);
}

TEST(Playback, KeysGoMoveByMove)
{
  const auto s = scene();
  const double first = s.player->endOf(0);
  EXPECT_EQ(after({"Right"}, s).time, first);
  const std::size_t slot = s.player->moveOfLine(9);
  s.player->seek(s.player->endOf(slot));
  ViewerLook look;
  changeLook("Left", false, s, {}, look);
  EXPECT_EQ(look.time, s.player->beginOf(slot));
  EXPECT_EQ(after({"End"}, s).time, s.player->duration());
  EXPECT_EQ(after({"End", "Home"}, s).time, 0);
  s.player->seek(0);
  EXPECT_EQ(after({"Left"}, s).time, 0);
}

TEST(Playback, LevelsStopAtBothEnds)
{
  const auto s = scene();
  EXPECT_EQ(after({"Next"}, s).level, 0u);
  EXPECT_TRUE(after({"Next"}, s).map);
  EXPECT_EQ(after({"Next", "Next", "Next", "Next", "Next"}, s).level, 2u);
  EXPECT_EQ(after({"Next", "Next", "Prior", "Prior", "Prior"}, s).level, 0u);
}

TEST(Playback, AFindingIsLookedAtWhereItsLineIsMilled)
{
  const auto s = scene();
  const ViewerLook look = after({"n"}, s);
  EXPECT_EQ(look.finding, 0u);
  EXPECT_EQ(s.player->program().moves[s.player->move()].line, 9u);
  EXPECT_EQ(after({"n", "n"}, s).finding, 1u);
  EXPECT_EQ(after({"n", "n", "n"}, s).finding, 0u);
  EXPECT_EQ(after({"b"}, s).finding, 1u);
  EXPECT_TRUE(viewer::movesCamera("n"));
}

TEST(Playback, SpeedsGoUpAndDownAndEnd)
{
  const auto s = scene();
  ViewerLook look;
  look.speed = 10;
  changeLook("Up", false, s, {}, look);
  EXPECT_EQ(look.speed, 20);
  changeLook("Down", false, s, {}, look);
  changeLook("Down", false, s, {}, look);
  EXPECT_EQ(look.speed, 5);
  for (int i = 0; i < 30; ++i)
    changeLook("Down", false, s, {}, look);
  EXPECT_EQ(look.speed, 1);
  EXPECT_EQ(viewer::suitableSpeed(3600), 100); // in less than a minute
  EXPECT_EQ(viewer::suitableSpeed(30), 1);
}

TEST(Playback, PclsKeysAreLeftToIt)
{
  const auto s = scene();
  ViewerLook look;
  for (const char* key :
       {"1", "9", "q", "e", "r", "j", "g", "u", "o", "plus", "p", "w"})
    EXPECT_FALSE(changeLook(key, false, s, {}, look)) << key;
}

TEST(Playback, EveryKeyIsInTheHelp)
{
  const auto s = scene();
  for (const char key : {'m', 'n', 'b', 'v', 't', 'k', 'd', 'y', 'a', 'i'}) {
    ViewerLook look;
    EXPECT_TRUE(changeLook(std::string(1, key), false, s, {0, -1}, look)) << key;
    EXPECT_NE(Viewer::help().find(key), std::string::npos) << key;
  }
}

TEST(Levels, AreTheLowestCutsOfTheRoughing)
{
  ViewerScene s;
  auto path = std::make_shared<CLCloud>();
  const auto add = [&](double z, unsigned level, Motion motion) {
    PointCL p(0, 0, z, motion);
    p.level = level;
    path->push_back(p);
  };
  add(5, 0, Motion::Rapid);
  add(-1, 0, Motion::Cut);
  add(-0.5, 0, Motion::Cut);
  add(-2, 1, Motion::Ramp); // no cut
  add(-2.5, 1, Motion::Cut);
  s.path = path;
  s.operations = {{"roughing", 0, 0, path->size()}};
  EXPECT_EQ(viewer::levelsOf(s), (std::vector<double>{-1, -2.5}));
}

TEST(Levels, OfAMapAloneAreATwentiethEach)
{
  ViewerScene s;
  auto map = std::make_shared<CellCloud>(3, 2);
  for (std::size_t i = 0; i < map->size(); ++i)
    (*map)[i].z = i == 0 ? -10.f : 0.f;
  s.map = map;
  const auto levels = viewer::levelsOf(s);
  ASSERT_EQ(levels.size(), 20u);
  EXPECT_NEAR(levels.front(), -0.5, 1e-6);
  EXPECT_NEAR(levels.back(), -10, 1e-6);
}
