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
    // The cutter of radius 2 overhangs on all sides.
    EXPECT_LE(lines.size(), std::size_t(std::ceil((width + 4) / 1.7)) + 1);
    EXPECT_LT(lines.begin()->first, -1.5);
    EXPECT_GT(lines.begin()->first, -2);
    EXPECT_GT(lines.rbegin()->first, width + 1.5);
    float before = lines.begin()->first;
    for (const auto& [at, ends] : lines) {
      EXPECT_LE(at - before, 1.7 + 1e-5);
      before = at;
      if (at > 0 && at < width) {
        EXPECT_LT(ends.first, 0);
        EXPECT_GT(ends.second, length);
      }
    }
  }
}

TEST_F(RasterLines, RunForthAndBackInTurn)
{
  const auto path = raster(stage, cloud);
  std::set<float> rows;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0 && path[i].label != path[i - 1].label) {
      EXPECT_EQ(path[i].label, path[i - 1].label + 1);
    }
    else if (i > 0) {
      const bool forth = rows.size() % 2 == 1;
      EXPECT_EQ(path[i].x > path[i - 1].x, forth) << i;
      EXPECT_LE(std::abs(path[i].x - path[i - 1].x), 0.9 + 1e-5);
      EXPECT_EQ(path[i].y, path[i - 1].y);
    }
    rows.insert(path[i].y);
    EXPECT_EQ(path[i].y, *rows.rbegin()) << "row after row";
  }
  EXPECT_EQ(stage.getReport().get("passes"), path.back().label + 1.0);
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
  EXPECT_EQ(passes.size(), 20u); // 10 rows of 2 from -2 to 12
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

namespace {

/// Cuts a block 0.3 deep along the path. Of all moves over its middle, the share that
/// had more material on their right than on their left before they came.
double materialOnTheRight(const CLCloud& path, const Tool& tool)
{
  StockField field({{0, 0, -2}, {60, 40, 0.3}}, 0.1, StockField::Bound::Nominal);
  const auto height = [&](const Eigen::Vector2d& p) {
    return field.height(static_cast<int>(p.x() / 0.1), static_cast<int>(p.y() / 0.1));
  };
  std::size_t right = 0, all = 0;
  forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
    const Eigen::Vector2d at = 0.5 * (a + b).template head<2>();
    const Eigen::Vector2d feed = (b - a).template head<2>();
    if (feed.norm() > 0 && at.x() > 20 && at.x() < 40 && at.y() > 14 && at.y() < 26) {
      const Eigen::Vector2d side =
          0.5 * Eigen::Vector2d(feed.y(), -feed.x()).normalized();
      right += height(at + side) > height(at - side) + 0.05;
      ++all;
    }
    field.cut(tool, a, b);
  });
  return static_cast<double>(right) / static_cast<double>(all);
}

} // namespace

TEST_F(RasterLines, OfOneWayHaveTheMaterialOnOneSide)
{
  const auto flat = surface({0, 0, 60, 40}, 0.25, [](double, double) { return 0; });
  stage.setStepOver(0.8);
  for (const double degrees : {0.0, 90.0, 143.0, -20.0}) {
    stage.setAngle(degrees);
    stage.setPattern(RasterPattern::OneWay);
    stage.setMillingMode(MillingMode::Climb);
    EXPECT_EQ(materialOnTheRight(raster(stage, flat), stage.getTool()), 1) << degrees;
    stage.setMillingMode(MillingMode::Conventional);
    EXPECT_EQ(materialOnTheRight(raster(stage, flat), stage.getTool()), 0) << degrees;
    stage.setPattern(RasterPattern::ZigZag);
    EXPECT_NEAR(materialOnTheRight(raster(stage, flat), stage.getTool()), 0.5, 0.1);
  }
}

TEST_F(RasterLines, OfOneWayKeepTheSideWhereRowsAreInserted)
{
  const auto slope =
      surface({0, 0, 60, 40}, 0.2, [](double, double y) { return 2 * y; });
  stage.setScallop(0.05);
  stage.setPattern(RasterPattern::OneWay);
  for (const auto mode : {MillingMode::Climb, MillingMode::Conventional}) {
    stage.setMillingMode(mode);
    const auto path = raster(stage, slope);
    ASSERT_GT(stage.getReport().get("inserted_passes"), 50);
    for (std::size_t i = 1; i < path.size(); ++i)
      if (path[i].label == path[i - 1].label) {
        EXPECT_GT(path[i].x, path[i - 1].x);
      }
      else if (mode == MillingMode::Climb) {
        EXPECT_LE(path[i].y, path[i - 1].y);
      }
      else {
        EXPECT_GE(path[i].y, path[i - 1].y);
      }
  }
}

TEST_F(RasterLines, AtAnyAngleLieAtThatAngle)
{
  for (const double degrees : {30.0, -75.0, 200.0}) {
    stage.setAngle(degrees);
    const auto path = raster(stage, cloud);
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    std::set<long> rows;
    for (const auto& p : path)
      rows.insert(std::lround(1e3 * (c * p.y - s * p.x)));
    const auto width = static_cast<double>(*rows.rbegin() - *rows.begin()) / 1e3;
    EXPECT_LE(static_cast<double>(rows.size()), 2 * (width / 1.7 + 1)) << "rounding";
    for (auto row = std::next(rows.begin()); row != rows.end(); ++row)
      EXPECT_LE(*row - *std::prev(row), 1701);
  }
}

TEST_F(RasterLines, ChooseTheirDirectionByThePart)
{
  const auto angleOver = [&](const Cloud::Ptr& part) {
    stage.setDirection(RasterDirection::Auto);
    stage.setScallop(0.01);
    raster(stage, part);
    return stage.getReport().get("angle_deg");
  };
  // A flat: the fewer rows the better.
  const auto flat = [](double, double) { return 0; };
  EXPECT_EQ(angleOver(surface({0, 0, 60, 20}, 0.5, flat)), 0);
  EXPECT_EQ(angleOver(surface({0, 0, 20, 60}, 0.5, flat)), 90);
  // Rows along the contour of a steep roof need not go up and down.
  const auto roof = [](double t) { return 3 * (15 - std::abs(t - 15)); };
  EXPECT_EQ(angleOver(surface(
                {0, 0, 30, 30}, 0.3, [&](double x, double) { return roof(x); })),
            90);
  EXPECT_EQ(angleOver(surface(
                {0, 0, 30, 30}, 0.3, [&](double, double y) { return roof(y); })),
            0);
}
