// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The cutter-location surface against closed forms.
#include "finish_test.h"

using namespace finish_test;

namespace {

constexpr double kFloat = 2e-6; // float32 at 30 mm

CLCloud over(const Cloud::Ptr& cloud,
             const Tool& tool,
             double allowance = 0,
             double step_over = 0.7)
{
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(tool);
  stage.setStepOver(step_over);
  stage.setForwardStep(0.6);
  stage.setAllowance(allowance);
  return raster(stage, cloud);
}

} // namespace

TEST(CLSurface, OverAPlaneIsThePlane)
{
  const double step = 0.1;
  const auto cloud = surface({-6, -6, 6, 6}, step, [](double, double) { return 1.25; });
  for (const auto& tool : kTools) {
    const auto path = over(cloud, tool);
    int inside = 0;
    for (const auto& p : path) {
      EXPECT_LE(p.z, 1.25f + kFloat);
      if (std::abs(p.x) > 6 || std::abs(p.y) > 6)
        continue; // the ball rolls down beside the plane's edge
      ++inside;
      EXPECT_GE(p.z, 1.25 - (tool.isBall() ? sink(1.5, step) : 0) - kFloat)
          << tool.describe() << " " << p.x << " " << p.y;
    }
    EXPECT_GT(inside, 300);
  }
}

TEST(CLSurface, OverASlopeIsTheSlopeOffsetAlongItsNormal)
{
  // The tip of a ball at 45 degrees stands R (1 / cos 45 - 1) above the plane.
  const double step = 0.1, r = 1.5;
  const auto cloud = surface({-8, -8, 8, 8}, step, [](double x, double) { return x; });
  const auto path = over(cloud, Tool::ball(1, 2 * r));
  int inside = 0;
  for (const auto& p : path) {
    const double truth = p.x + r * (std::sqrt(2.0) - 1);
    if (std::abs(p.x) > 6 || std::abs(p.y) > 6)
      continue;
    ++inside;
    EXPECT_LE(p.z, truth + kFloat);
    // The spacing along the slope is step * sqrt 2 one way, step the other.
    EXPECT_GE(p.z, truth - 1.6 * sink(r, std::sqrt(2.0) * step));
    EXPECT_NEAR(p.normal_x, -std::sqrt(0.5), 0.05);
    EXPECT_NEAR(p.normal_y, 0, 0.05);
    EXPECT_NEAR(p.normal_z, std::sqrt(0.5), 0.05);
  }
  EXPECT_GT(inside, 300);
}

TEST(CLSurface, OverASphereIsTheOffsetSphere)
{
  const double R = 30, r = 1.5, step = 0.07;
  const auto cloud = surface({-8, -8, 8, 8}, step, [&](double x, double y) {
    return std::sqrt(R * R - x * x - y * y);
  });
  const auto path = over(cloud, Tool::ball(1, 2 * r));
  int inside = 0;
  for (const auto& p : path) {
    const double truth =
        std::sqrt((R + r) * (R + r) - double(p.x) * p.x - double(p.y) * p.y) - r;
    if (std::abs(p.x) > 7.5 || std::abs(p.y) > 7.5)
      continue;
    ++inside;
    EXPECT_LE(p.z, truth + 2 * kFloat);
    EXPECT_GE(p.z, truth - 1.3 * sink(r, step));
    const Eigen::Vector3f n(p.normal_x, p.normal_y, p.normal_z);
    const Eigen::Vector3f centre(p.x, p.y, p.z + float(r));
    EXPECT_GT(n.dot(centre.normalized()), 0.998f);
  }
  EXPECT_GT(inside, 300);
}

TEST(CLSurface, OverAConesFlankIsTheFlankOffsetAlongItsNormal)
{
  const double r = 1.5, step = 0.1;
  const auto cloud = surface({10, 10, 50, 50}, step, cone);
  const auto path = over(cloud, Tool::ball(1, 2 * r), 0, 2.0);
  int inside = 0;
  for (const auto& p : path) {
    const double d = std::hypot(p.x - 30, p.y - 30);
    if (d < r || d > 17)
      continue; // the cone's tip and foot
    ++inside;
    const double truth = 20 - d + r * (std::sqrt(2.0) - 1);
    EXPECT_LE(p.z, truth + kFloat);
    EXPECT_GE(p.z, truth - 1.6 * sink(r, std::sqrt(2.0) * step));
  }
  EXPECT_GT(inside, 500);
}

TEST(CLSurface, ABallTooWideForAChannelRestsOnBothEdges)
{
  // Half-round of radius 8; a ball of radius 10 over its middle touches the edges only.
  Cloud::Ptr cloud = surface({0, 0, 60, 40}, 0.25, channel);
  addSurface(*cloud, {0, 12, 60, 12}, 0.05, [](double, double) { return 10; });
  addSurface(*cloud, {0, 28, 60, 28}, 0.05, [](double, double) { return 10; });
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(Tool::ball(1, 20));
  stage.setStepOver(20);
  stage.setBoundary({{-20, 0}, {80, 0}, {80, 40}, {-20, 40}}); // rows at 0, 20, 40
  stage.setForwardStep(1);
  const auto path = raster(stage, cloud);
  int middle = 0;
  for (const auto& p : path) {
    if (p.y != 20 || p.x < 0 || p.x > 60)
      continue;
    ++middle;
    EXPECT_NEAR(p.z, 10 - (10 - std::sqrt(100.0 - 64.0)), 1e-4);
  }
  EXPECT_GT(middle, 50);
  // A ball that fits lies on the groove's bottom.
  stage.setTool(Tool::ball(1, 10));
  for (const auto& p : raster(stage, cloud))
    if (p.y == 20 && p.x >= 0 && p.x <= 60) {
      EXPECT_NEAR(p.z, 2, sink(5, 0.5));
    }
}

TEST(CLSurface, EveryPointIsTheDropOverAllPoints)
{
  const Rectangle area{0, 0, 14, 12};
  const auto cloud = surface(area, 0.35, Bumps(area, 6, 9, 21));
  const auto points = pointsOf(*cloud);
  for (const double allowance : {0.0, 0.25})
    for (const auto& tool : kTools) {
      const auto path = over(cloud, tool, allowance);
      ASSERT_GT(path.size(), 300u);
      double floor = 1e9;
      for (const auto& p : points)
        floor = std::min(floor, p.z());
      for (const auto& p : path) {
        // x and y were rounded to float after the drop; where a point is at the rim,
        // that decides whether it is met.
        double low = 1e9, high = -1e9;
        for (const double nudge : {-1.0, 0.0, 1.0}) {
          const double z = std::max(
              floor,
              allowance +
                  brute::drop(points, tool.grown(allowance + nudge * 1e-6), p.x, p.y));
          low = std::min(low, z);
          high = std::max(high, z);
        }
        EXPECT_GE(p.z, low - 1e-5) << tool.describe();
        EXPECT_LE(p.z, high + 1e-5) << tool.describe();
      }
    }
}

TEST(CLSurface, TheAllowanceIsLeftAlongTheNormalOfASlope)
{
  const auto cloud =
      surface({-8, -8, 8, 8}, 0.1, [](double x, double) { return 1.2 * x; });
  const auto points = pointsOf(*cloud);
  for (const auto& tool : kTools) {
    const auto path = over(cloud, tool, 0.4);
    for (std::size_t i = 0; i < path.size(); i += 17) {
      const Eigen::Vector3d tip = position(path[i]);
      if (tip.head<2>().cwiseAbs().maxCoeff() > 5)
        continue;
      // Nothing of the part inside the tool grown by a hair less than the allowance,
      // something inside the tool grown by a hair more.
      const auto meets = [&](double by) {
        const Tool t = tool.grown(by);
        const Eigen::Vector3d at = tip - Eigen::Vector3d(0, 0, by);
        for (const auto& p : points)
          if (brute::inside(t, at, p) > 1e-4)
            return true;
        return false;
      };
      EXPECT_FALSE(meets(0.4)) << tool.describe();
      EXPECT_TRUE(meets(0.4 + 0.01)) << tool.describe();
    }
  }
}

TEST(CLSurface, TheStepOverOfTheFormulaLeavesTheScallopWantedOnAFlat)
{
  const auto cloud = surface({0, 0, 4, 4}, 0.02, [](double, double) { return -1; });
  const Tool tool = Tool::ball(1, 3);
  for (const double scallop : {0.01, 0.05}) {
    CLSurface<pcl::PointXYZ> stage;
    stage.setTool(tool);
    stage.setScallop(scallop);
    EXPECT_DOUBLE_EQ(stage.getStepOver(),
                     2 * std::sqrt(2 * 1.5 * scallop - scallop * scallop));
    stage.setForwardStep(0.1);
    const auto path = raster(stage, cloud);
    StockField field({{1, 0.5, -3}, {1.1, 3.5, 0}}, 0.01, StockField::Bound::Nominal);
    forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
      field.cut(tool, a, b);
    });
    double high = -9;
    for (int row = 0; row < field.rows(); ++row)
      high = std::max(high, field.height(5, row));
    // Lines may lie nearer together, so that they divide the part evenly.
    EXPECT_LE(high + 1, scallop * 1.001);
    EXPECT_GE(high + 1, scallop * 0.7);
  }
}

TEST(CLSurface, GoesNoLowerThanTheFloor)
{
  const auto cloud = sample(shapes()[1], 0.5, 2); // the dome, on the ground
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(Tool::ball(1, 3));
  stage.setStepOver(2);
  stage.setFloor(4.25);
  float lowest = 1e9f, highest = -1e9f;
  for (const auto& p : raster(stage, cloud)) {
    lowest = std::min(lowest, p.z);
    highest = std::max(highest, p.z);
  }
  EXPECT_EQ(lowest, 4.25f);
  EXPECT_NEAR(highest, 15, 0.1);
}

TEST(CLSurface, BesideThePartStopsAtTheLowestPoint)
{
  const auto cloud = sample(shapes()[0], 0.5, 3);
  float lowest = 1e9f;
  for (const auto& p : *cloud)
    lowest = std::min(lowest, p.z);
  for (const auto& p : over(cloud, Tool::ball(1, 5)))
    EXPECT_GE(p.z, lowest);
}
