// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How the lines of a raster lie, and what it refuses.
#include "finish_test.h"

#include <map>
#include <set>

using namespace finish_test;

namespace {

struct RasterStage : ::testing::Test {
  CLSurface<pcl::PointXYZ> stage;
  const Cloud::Ptr cloud = sample(shapes()[5], 0.5, 6); // 60 x 40
  RasterStage()
  {
    stage.setTool(Tool::ball(1, 4));
    stage.setStepOver(1.7);
    stage.setForwardStep(0.9);
  }
  template <typename E>
  void expectRefused(const char* why)
  {
    CLCloud output;
    output.push_back(PointCL(1, 2, 3));
    EXPECT_THROW(stage.filter(output), E) << why;
    ASSERT_EQ(output.size(), 1u) << why;
    EXPECT_EQ(output[0].x, 1.f) << why;
  }
};
using RasterLines = RasterStage;
using RasterRefuses = RasterStage;

} // namespace

TEST_F(RasterLines, AreAtMostTheStepOverApartAndReachOverThePart)
{
  for (const auto direction : {RasterDirection::AlongX, RasterDirection::AlongY}) {
    stage.setDirection(direction);
    std::map<float, std::pair<float, float>> lines; // place -> first, last along
    for (const auto& p : raster(stage, cloud)) {
      const bool along_x = direction == RasterDirection::AlongX;
      const float at = along_x ? p.y : p.x, along = along_x ? p.x : p.y;
      auto& ends = lines.emplace(at, std::make_pair(along, along)).first->second;
      ends.first = std::min(ends.first, along);
      ends.second = std::max(ends.second, along);
    }
    const double width = direction == RasterDirection::AlongX ? 40 : 60;
    const double length = 100 - width;
    EXPECT_LE(lines.size(), std::size_t(std::ceil(width / 1.7)) + 1);
    EXPECT_LT(lines.begin()->first, 0.5);
    EXPECT_GT(lines.rbegin()->first, width - 0.5);
    float before = lines.begin()->first;
    for (const auto& [at, ends] : lines) {
      EXPECT_LE(at - before, 1.7 + 1e-5);
      before = at;
      EXPECT_LT(ends.first, 0); // the cutter overhangs
      EXPECT_GT(ends.second, length);
    }
  }
}

TEST_F(RasterLines, RunForthAndBackInTurn)
{
  const auto path = raster(stage, cloud);
  std::uint32_t passes = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].label == path[i - 1].label) {
      const bool forth = path[i].label % 2 == 0;
      EXPECT_EQ(path[i].x > path[i - 1].x, forth) << i;
      EXPECT_LE(std::abs(path[i].x - path[i - 1].x), 0.9 + 1e-5);
      EXPECT_EQ(path[i].y, path[i - 1].y);
    }
    else {
      EXPECT_EQ(path[i].label, path[i - 1].label + 1);
      passes = path[i].label;
    }
  EXPECT_EQ(stage.getReport().get("passes"), passes + 1.0);
}

TEST_F(RasterLines, AreInterruptedWhereNoPointIsUnderTheCutter)
{
  Cloud::Ptr two = surface({0, 0, 10, 10}, 0.5, [](double, double) { return 0; });
  addSurface(*two, {20, 0, 30, 10}, 0.5, [](double, double) { return 0; });
  const auto path = raster(stage, two);
  std::map<std::uint32_t, std::pair<float, float>> passes;
  for (const auto& p : path) {
    EXPECT_TRUE(p.x < 12.001 || p.x > 17.999) << p.x;
    auto& x = passes.emplace(p.label, std::make_pair(p.x, p.x)).first->second;
    x = {std::min(x.first, p.x), std::max(x.second, p.x)};
  }
  EXPECT_EQ(passes.size(), 14u); // 7 lines of 2
  for (const auto& pass : passes)
    EXPECT_LT(pass.second.second - pass.second.first, 14.1f);
}

TEST_F(RasterLines, LieOnlyOverTheIndicesGiven)
{
  pcl::IndicesPtr left(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 25)
      left->push_back(static_cast<pcl::index_t>(i));
  stage.setIndices(left);
  const auto path = raster(stage, cloud);
  ASSERT_FALSE(path.empty());
  for (const auto& p : path)
    EXPECT_LE(p.x, 27);

  Cloud::Ptr only(new Cloud(*cloud, *left));
  CLSurface<pcl::PointXYZ> fresh = stage;
  fresh.setIndices(pcl::IndicesPtr(new pcl::Indices));
  CLSurface<pcl::PointXYZ> plain;
  plain.setTool(stage.getTool());
  plain.setStepOver(stage.getStepOver());
  plain.setForwardStep(stage.getForwardStep());
  EXPECT_EQ(bytes(raster(plain, only)), bytes(path));
}

TEST_F(RasterLines, IgnorePointsThatAreNotFinite)
{
  const std::string clean = bytes(raster(stage, cloud));
  Cloud::Ptr dirty(new Cloud(*cloud));
  const float nan = std::nanf(""), inf = HUGE_VALF;
  dirty->push_back({nan, 5, 5});
  dirty->push_back({5, nan, 99});
  dirty->insert(dirty->begin() + 1000, pcl::PointXYZ(7, 7, nan));
  dirty->push_back({8, 8, inf});
  dirty->push_back({inf, 8, 8});
  dirty->is_dense = false;
  EXPECT_EQ(bytes(raster(stage, dirty)), clean);
}

TEST_F(RasterLines, AreTheSameForAnyNumberOfThreads)
{
  stage.setNumberOfThreads(1);
  const std::string one = bytes(raster(stage, cloud));
  for (const unsigned threads : {2u, 5u}) {
    stage.setNumberOfThreads(threads);
    EXPECT_EQ(bytes(raster(stage, cloud)), one) << threads;
  }
}

TEST_F(RasterLines, OverAnIndexAreThoseOverItsPoints)
{
  const std::string own = bytes(raster(stage, cloud));
  stage.setModel(std::make_shared<pointmill::SurfaceModel>(indexOf(*cloud)));
  EXPECT_EQ(bytes(raster(stage, cloud)), own);
}

TEST_F(RasterRefuses, EmptyClouds)
{
  expectRefused<DataError>("none");
  stage.setInputCloud(Cloud::ConstPtr(new Cloud));
  expectRefused<DataError>("empty");
  Cloud::Ptr nothing(new Cloud);
  for (int i = 0; i < 20; ++i)
    nothing->push_back({std::nanf(""), 0, 0});
  stage.setInputCloud(nothing);
  expectRefused<DataError>("all NaN");
}

TEST_F(RasterRefuses, AbsurdParameters)
{
  stage.setInputCloud(cloud);
  stage.setStepOver(0);
  expectRefused<ParameterError>("no step-over");
  stage.setStepOver(std::nan(""));
  expectRefused<ParameterError>("step-over NaN");
  stage.setStepOver(1);
  stage.setForwardStep(-1);
  expectRefused<ParameterError>("backward step");
  stage.setForwardStep(1);
  stage.setAllowance(-0.1);
  expectRefused<ParameterError>("negative allowance");
  stage.setAllowance(0);
  stage.setTool(Tool::ball(1, -3));
  expectRefused<ParameterError>("tool");
}

TEST_F(RasterRefuses, AScallopOfAFlatTool)
{
  // A flat end leaves none; the formula gives no step-over.
  stage.setInputCloud(cloud);
  stage.setTool(Tool::flat(1, 4));
  stage.setScallop(0.01);
  expectRefused<ParameterError>("flat");
}

TEST_F(RasterLines, OfAMinimumSlopeKeepTheSteepStretchesOnly)
{
  // A roof: flat, 60 degrees up, flat. Lines along X meet the slope, lines along Y not.
  const double rise = std::tan(M_PI / 3);
  const auto roof = surface({0, 0, 40, 12}, 0.2, [&](double x, double) {
    return rise * std::min(8.0, std::max(0.0, x - 16));
  });
  stage.setForwardStep(0.5);
  stage.setFloor(0);
  const auto all = raster(stage, roof);
  stage.setMinSlope(45);
  const auto steep = raster(stage, roof);
  ASSERT_FALSE(steep.empty());
  EXPECT_LT(steep.size(), all.size() / 2);
  std::size_t on_slope = 0;
  for (const auto& p : steep)
    on_slope += p.x > 14 && p.x < 25;
  std::size_t wanted = 0;
  for (const auto& p : all)
    wanted += p.x > 16.5 && p.x < 22;
  std::size_t held = 0;
  for (const auto& p : steep)
    held += p.x > 16.5 && p.x < 22;
  EXPECT_EQ(held, wanted) << "of the slope nothing is left out";
  // Beside the part the ball falls off its ends, steeply too.
  for (const auto& p : steep)
    EXPECT_TRUE(p.x < 1.5 || (p.x > 13 && p.x < 26) || p.x > 38.5) << p.x;
  EXPECT_GT(on_slope, 0u);
  for (std::size_t i = 1; i < steep.size(); ++i)
    if (steep[i].label == steep[i - 1].label) {
      EXPECT_LE(std::abs(steep[i].x - steep[i - 1].x), 0.5 + 1e-5)
          << "a chord over what was left out";
    }
  stage.setMinSlope(75);
  for (const auto& p : raster(stage, roof))
    EXPECT_TRUE(p.x < 1.5 || p.x > 38.5) << p.x;
}
