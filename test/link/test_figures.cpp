// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "link_test.h"

using namespace link_test;

namespace {

PointCL at(double x, double y, double z, Motion how, float feed, std::uint32_t label)
{
  PointCL p(x, y, z, how);
  p.feed = feed;
  p.label = label;
  return p;
}

} // namespace

TEST(PathFigures, AreThoseOfTheHandComputation)
{
  CLCloud path;
  path.push_back(at(0, 0, 10, Motion::Rapid, 0, 0));
  path.push_back(at(30, 40, 10, Motion::Rapid, 0, 0));    // 50 rapid
  path.push_back(at(30, 40, 1, Motion::Rapid, 0, 0));     // 9 rapid
  path.push_back(at(30, 40, -1, Motion::Plunge, 100, 0)); // 2 at 100
  path.push_back(at(90, 40, -1, Motion::Cut, 600, 0));    // 60 at 600
  path.push_back(at(90, 40, 10, Motion::Retract, 0, 1));  // 11 rapid
  path.push_back(at(90, 70, 10, Motion::Rapid, 0, 1));    // 30 rapid
  path.push_back(at(90, 70, -2, Motion::Plunge, 240, 1)); // 12 at 240
  path.push_back(at(93, 74, -2, Motion::Link, 50, 1));    // 5 at 50
  path.push_back(at(93, 74, 10, Motion::Retract, 0, 1));  // 12 rapid
  const auto figures = measurePath(path, 1000);
  EXPECT_EQ(figures.cl_points, 10u);
  EXPECT_EQ(figures.passes, 2u);
  EXPECT_EQ(figures.retracts, 2u);
  EXPECT_NEAR(figures.cutting_length, 2 + 60 + 12 + 5, 1e-6);
  EXPECT_NEAR(figures.rapid_length, 50 + 9 + 11 + 30 + 12, 1e-6);
  EXPECT_NEAR(figures.minutes, 0.02 + 0.1 + 0.05 + 0.1 + 0.112, 1e-6);
}

TEST(PathFigures, OfNothingAreNothing)
{
  const auto figures = measurePath(CLCloud(), 1000);
  EXPECT_EQ(figures.passes, 0u);
  EXPECT_EQ(figures.minutes, 0);
}

TEST(PathFigures, OfALinkedPathAreFinite)
{
  LinkPasses linker;
  linker.setClearancePlane(5);
  linker.setStock(fieldOf({{0, 0, -5}, {40, 40, 0}}));
  CLCloud passes;
  addPass(passes, 0, {{10, 10, -2}, {30, 10, -2}});
  addPass(passes, 1, {{10, 30, -2}, {30, 30, -2}});
  const auto path = link(linker, passes);
  const auto figures = measurePath(path, 5000);
  EXPECT_EQ(figures.passes, 2u);
  EXPECT_EQ(figures.retracts, 2u);
  EXPECT_TRUE(std::isfinite(figures.minutes));
  EXPECT_GT(figures.cutting_length, 40);
}
