// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Links that stay down between two passes.
#include "link_test.h"

#include <pointmill/finish/cl_surface.h>

using namespace link_test;

namespace {

constexpr Rectangle kArea{0, 0, 24, 18};
const Stock kBlock{{0, 0, -1}, {24, 18, 7}};

struct StayDown : ::testing::Test {
  LinkPasses linker;
  Cutting cutting;
  const Tool tool = Tool::ball(1, 3);
  const Cloud::Ptr cloud = surface(kArea, 0.3, Bumps(kArea, 5.5, 7, 51));
  static constexpr double allowance = 0.1;

  StayDown()
  {
    cutting.feed = 900;
    cutting.plunge_feed = 200;
    linker.setTool(tool);
    linker.setCutting(cutting);
    linker.setClearancePlane(12);
    linker.setPart(indexOf(*cloud), allowance, -0.5);
    linker.setStayDown(6);
    linker.setStock(machined());
  }

  /// The stock with all but a skin of the part gone.
  std::shared_ptr<StockField> machined() const
  {
    const auto field = fieldOf(kBlock);
    const auto index = indexOf(*cloud);
    const Tool fine = Tool::flat(9, 1);
    for (double y = 0; y < 18; y += 0.25)
      for (double x = 0; x < 24; x += 0.25) {
        const double z = index->drop(fine, x, y).tip + 0.3;
        field->cut(fine, Eigen::Vector3d(x, y, 12), Eigen::Vector3d(x, y, z));
      }
    return field;
  }
  CLCloud lines() const
  {
    CLSurface<pcl::PointXYZ> stage;
    stage.setTool(tool);
    stage.setStepOver(0.8);
    stage.setForwardStep(0.3);
    stage.setAllowance(allowance);
    stage.setInputCloud(cloud);
    CLCloud path;
    stage.filter(path);
    return path;
  }
  /// The deepest that a point gets into the tool with its allowance on the links.
  double deepestOnLinks(const CLCloud& path) const
  {
    const Tool grown = tool.grown(allowance);
    const Eigen::Vector3d down(0, 0, allowance);
    double worst = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (path[i].getMotion() != Motion::Link)
        continue;
      const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
      for (const auto& p : *cloud)
        if (std::hypot(p.x - b.x(), p.y - b.y()) < 9)
          worst = std::max(
              worst,
              brute::gouge(
                  grown, a - down, b - down, Eigen::Vector3d(p.x, p.y, p.z), 100));
    }
    return worst;
  }
};

} // namespace

TEST_F(StayDown, LinksTheLinesOfARasterClearOfThePart)
{
  const auto path = link(linker, lines());
  EXPECT_GT(linker.getReport().get("links"), 10);
  EXPECT_EQ(linker.getReport().get("links") + linker.getReport().get("lifts") +
                linker.getReport().get("retracts"),
            linker.getReport().get("passes"));
  EXPECT_LE(deepestOnLinks(path), 1e-4);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].getMotion() == Motion::Link) {
      EXPECT_GT(path[i].feed, 0.f);
      const Eigen::Vector3d move = position(path[i]) - position(path[i - 1]);
      EXPECT_TRUE(move.z() == 0 || move.head<2>().norm() == 0) << i;
    }
}

TEST_F(StayDown, WithoutItAllPassesRetract)
{
  linker.setStayDown(0);
  link(linker, lines());
  EXPECT_EQ(linker.getReport().get("links"), 0);
}

TEST_F(StayDown, ALinkOverAFinRisesOverIt)
{
  const auto part = surface({0, 0, 24, 18}, 0.3, [](double x, double) {
    return std::abs(x - 12) < 0.2 ? 5.0 : 0.0;
  });
  linker.setPart(indexOf(*part), allowance, -0.5);
  linker.setStock(nullptr);
  linker.setRapidRate(100); // the way over the clearance plane takes longer
  CLCloud passes;
  addPass(passes, 0, {{6, 9, 0.1}, {9.5, 9, 0.1}});
  addPass(passes, 1, {{14.5, 9, 0.1}, {18, 9, 0.1}});
  const auto path = link(linker, passes);
  EXPECT_EQ(linker.getReport().get("links"), 1);
  float top = 0;
  for (const auto& p : path)
    if (p.getMotion() == Motion::Link)
      top = std::max(top, p.z);
  EXPECT_NEAR(top, 5.1, 0.02); // the fin and the allowance
}

TEST_F(StayDown, PassesFartherApartThanItAllowsRetract)
{
  linker.setStock(nullptr);
  CLCloud passes;
  addPass(passes, 0, {{4, 9, 7}, {6, 9, 7}});
  addPass(passes, 1, {{12.1, 9, 7}, {15, 9, 7}});
  link(linker, passes);
  EXPECT_EQ(linker.getReport().get("links"), 0);
  linker.setStayDown(6.2);
  link(linker, passes);
  EXPECT_EQ(linker.getReport().get("links"), 1);
}

TEST_F(StayDown, ALinkDoesNotRunThroughStandingStock)
{
  linker.setStock(fieldOf(kBlock)); // untouched, 7 high
  CLCloud passes;
  addPass(passes, 0, {{4, 5, 5.8}, {9, 5, 5.8}});
  addPass(passes, 1, {{9, 9, 5.8}, {4, 9, 5.8}});
  const auto path = link(linker, passes);
  EXPECT_EQ(linker.getReport().get("links"), 0);
  expectSound(path, 12, cutting, 3);
}

TEST_F(StayDown, ALinkDoesNotPlungeIntoStandingStock)
{
  // Between two passes stands a ridge that the link has to rise over; on its far side
  // the stock is as high as the ridge, and the next pass begins at its foot.
  const auto part = surface({0, 0, 24, 18}, 0.3, [](double x, double) {
    return std::abs(x - 12) < 0.2 ? 5.0 : 0.0;
  });
  linker.setPart(indexOf(*part), allowance, -0.5);
  const Stock block{{0, 0, -1}, {24, 18, 5}};
  linker.setStock(fieldOf(block));
  CLCloud passes;
  addPass(passes, 0, {{9.5, 2, 0.1}, {9.5, 16, 0.1}});
  addPass(passes, 1, {{14.5, 16, 0.1}, {14.5, 2, 0.1}});
  const auto path = link(linker, passes);
  Heap heap(block, 0.3);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    const double taken = heap.cut(tool, a, b);
    if ((a - b).head<2>().norm() == 0) {
      EXPECT_LE(taken, 0.6) << "straight down through the stock at " << i;
    }
  }
}
