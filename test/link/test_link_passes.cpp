// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "link_test.h"

#include <pointmill/rough/zigzag_roughing.h>
#include <pointmill/slice/occupancy_map.h>

using namespace link_test;

namespace {

const Stock kBox{{0, 0, -6}, {24, 18, 0}};

struct Linking : ::testing::Test {
  LinkPasses linker;
  Cutting cutting;
  const Tool tool = Tool::flat(1, 5);

  Linking()
  {
    cutting.feed = 900;
    cutting.plunge_feed = 200;
    linker.setTool(tool);
    linker.setCutting(cutting);
    linker.setClearancePlane(8);
    linker.setRampAngle(5);
    linker.setStock(fieldOf(kBox));
  }

  /// Roughing passes of a bumpy part in the box.
  static CLCloud roughing(const Tool& with)
  {
    const Rectangle area{0, 0, 24, 18};
    const Bumps bumps(area, 5.5, 6, 41);
    const auto cloud =
        surface(area, 0.4, [&](double x, double y) { return bumps(x, y) - 5.7; });
    OccupancyMap<pcl::PointXYZ> occupancy;
    occupancy.setCellSize(0.4);
    occupancy.setInputCloud(cloud);
    CellCloud::Ptr map(new CellCloud);
    occupancy.filter(*map);
    ZigZagRoughing strategy;
    strategy.setTool(with);
    strategy.setAllowance(0.2);
    strategy.setStepDown(1.5);
    strategy.setStepOver(2);
    strategy.setStock(fieldOf(kBox));
    strategy.setPart(indexOf(*cloud));
    strategy.setInputCloud(map);
    CLCloud passes;
    strategy.filter(passes);
    return passes;
  }
};

} // namespace

TEST_F(Linking, ARoughingPathIsSound)
{
  const auto path = link(linker, roughing(tool));
  expectSound(path, 8, cutting, 5);
  EXPECT_GT(linker.getReport().get("retracts"), 3);
  EXPECT_GT(linker.getReport().get("ramps"), 1);
}

TEST_F(Linking, RapidsDownEndAboveWhatStillStands)
{
  for (const auto& with : {tool, Tool::ball(2, 5)}) {
    linker.setTool(with);
    linker.setStock(fieldOf(kBox));
    const auto path = link(linker, roughing(with));
    Heap heap(kBox, 0.3);
    int downs = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
      if (!isRapid(path[i])) {
        heap.cut(with, a, b);
        continue;
      }
      const double low = std::min(a.z(), b.z());
      if (path[i].getMotion() == Motion::Rapid && b.z() < a.z()) {
        ++downs;
        EXPECT_GE(low, heap.highest(b.x(), b.y(), with.radius()) + 1.0 - 1e-4)
            << "the approach of 1 mm at " << i;
      }
      EXPECT_LE(heap.cut(with, a, b), 1e-6) << "a rapid cuts at " << i;
    }
    EXPECT_GT(downs, 3);
  }
}

TEST_F(Linking, EntersMaterialOnARampNotStraightDown)
{
  // In the middle of the block: no feed move goes straight down through the stock.
  CLCloud passes;
  addPass(passes, 0, {{5, 9, -2}, {19, 9, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(linker.getReport().get("ramps"), 1);
  EXPECT_EQ(linker.getReport().get("plunges"), 0);
  Heap heap(kBox, 0.3);
  double ramped = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    const double taken = heap.cut(tool, a, b);
    if ((a - b).head<2>().norm() == 0) {
      EXPECT_LE(taken, 0.051) << i;
    }
    if (path[i].getMotion() == Motion::Ramp)
      ramped += a.z() - b.z();
  }
  EXPECT_NEAR(ramped, 2.05, 0.06);
}

TEST_F(Linking, ARampStaysOnItsPassAndEndsAtItsBeginning)
{
  CLCloud passes;
  addPass(passes, 0, {{5, 9, -2}, {9, 9, -2}, {9, 13, -2}, {19, 13, -2}});
  const auto path = link(linker, passes);
  int ramps = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].getMotion() == Motion::Ramp) {
      ++ramps;
      EXPECT_GE(path[i].z, -2.f);
      const bool first = path[i].y == 9 && path[i].x >= 5 && path[i].x <= 9;
      const bool second = path[i].x == 9 && path[i].y >= 9 && path[i].y <= 13;
      const bool third = path[i].y == 13 && path[i].x >= 9 && path[i].x <= 19;
      EXPECT_TRUE(first || second || third) << path[i].x << " " << path[i].y;
      if (path[i + 1].getMotion() != Motion::Ramp) {
        EXPECT_EQ(position(path[i]), position(passes[0]));
      }
    }
  EXPECT_GT(ramps, 3);
}

TEST_F(Linking, APassTooShortForARampIsPlungedInto)
{
  CLCloud passes;
  addPass(passes, 0, {{12, 9, -2}});
  linker.setTool(Tool::ball(2, 5)); // cuts at its centre
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(linker.getReport().get("plunges"), 1);
  EXPECT_EQ(linker.getReport().get("ramps"), 0);
  bool plunged = false;
  for (const auto& p : path)
    if (p.getMotion() == Motion::Plunge && p.z == -2) {
      plunged = true;
      EXPECT_FLOAT_EQ(p.feed, 200);
    }
  EXPECT_TRUE(plunged);
}

TEST_F(Linking, AFlatEndMillIsNotPlungedIntoMaterial)
{
  CLCloud passes;
  addPass(passes, 0, {{12, 9, -2}});
  addPass(passes, 1, {{5, 9, -2}, {25, 9, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(linker.getReport().get("skipped"), 1);
  EXPECT_EQ(linker.getReport().get("passes"), 1);
  EXPECT_EQ(linker.getReport().get("plunges"), 0);
}

TEST_F(Linking, OnlyAnEndWithoutAFlatIsPlunged)
{
  CLCloud passes;
  addPass(passes, 0, {{12, 9, -2}});
  addPass(passes, 1, {{5, 9, -2}, {25, 9, -2}});
  const auto skipped = [&](const Tool& other) {
    linker.setTool(other);
    linker.setStock(fieldOf(kBox)); // whole
    link(linker, passes);
    return linker.getReport().get("skipped");
  };
  EXPECT_EQ(skipped(Tool::bull(1, 5, 1)), 1);
  EXPECT_EQ(skipped(Tool::taperBall(1, 2, 5, 5)), 0);
  EXPECT_EQ(skipped(Tool::taperBull(1, 3, 0.5, 5, 5)), 1);
  EXPECT_EQ(skipped(Tool::cone(1, 30, 5)), 0);
}

TEST_F(Linking, AHeavyCutIsSlowedInProportion)
{
  // A slot of 5 x 4 mm is 20 mm2; full feed is for a tenth of 5 x 5.
  CLCloud passes;
  addPass(passes, 0, {{-6, 9, -4}, {36, 9, -4}});
  linker.setNominalStock(
      std::make_shared<StockField>(kBox, 0.25, StockField::Bound::Nominal));
  const auto path = link(linker, passes);
  bool cut = false;
  for (const auto& p : path)
    if (p.getMotion() == Motion::Cut) {
      cut = true;
      EXPECT_LT(p.feed, 900 * 0.35);
      EXPECT_GE(p.feed, 900 * 0.1f);
    }
  EXPECT_TRUE(cut);
}

TEST_F(Linking, OutsideTheStockGoesStraightDown)
{
  CLCloud passes;
  addPass(passes, 0, {{-10, 9, -2}, {30, 9, -2}});
  const auto path = link(linker, passes);
  EXPECT_EQ(linker.getReport().get("ramps") + linker.getReport().get("plunges"), 0);
  EXPECT_NEAR(path[1].z, -1, 1e-6) << "a rapid down to the approach above the pass";
  EXPECT_EQ(path[1].getMotion(), Motion::Rapid);
}

TEST_F(Linking, EveryPassIsCutPointByPointInItsOrder)
{
  const auto passes = roughing(tool);
  const auto path = link(linker, passes);
  std::size_t at = 0;
  for (const auto& p : passes) {
    while (at < path.size() && (isRapid(path[at]) || path[at].x != p.x ||
                                path[at].y != p.y || path[at].z != p.z))
      ++at;
    ASSERT_LT(at, path.size()) << "a point of the passes is missing";
  }
  EXPECT_EQ(linker.getReport().get("passes"), passes.back().label + 1.0);
}

TEST_F(Linking, CutsTheStockAlong)
{
  const auto stock = fieldOf(kBox);
  linker.setStock(stock);
  CLCloud passes;
  addPass(passes, 0, {{5, 9, -2}, {19, 9, -2}});
  link(linker, passes);
  EXPECT_FLOAT_EQ(stock->highest(12, 9, 1), -2);
  EXPECT_EQ(stock->highest(12, 15, 1), 0);
  // The second time there is nothing to ramp into.
  link(linker, passes);
  EXPECT_EQ(linker.getReport().get("ramps"), 0);
}

TEST_F(Linking, ASteeperRampIsShorter)
{
  CLCloud passes;
  addPass(passes, 0, {{5, 9, -2}, {19, 9, -2}});
  double last = 1e9;
  for (const double degrees : {1.0, 3.0, 10.0}) {
    linker.setRampAngle(degrees);
    linker.setStock(fieldOf(kBox));
    const auto path = link(linker, passes);
    expectSound(path, 8, cutting, degrees);
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
      if (path[i].getMotion() == Motion::Ramp)
        length += (position(path[i]) - position(path[i - 1])).head<2>().norm();
    EXPECT_GE(length, 2.0 / std::tan(degrees * M_PI / 180));
    EXPECT_LT(length, last);
    last = length;
  }
}

TEST_F(Linking, DescendingCutsAreSlowedToThePlungeFeed)
{
  CLCloud passes;
  addPass(passes, 0, {{-4, 9, 4}, {6, 9, -6}, {16, 9, -6}, {26, 9, 4}});
  linker.setStock(nullptr); // in the air: nothing but the slope decides
  linker.setFeedStep(0);
  const auto path = link(linker, passes);
  bool down = false, level = false, up = false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].getMotion() != Motion::Cut)
      continue;
    const float rise = path[i].z - path[i - 1].z;
    if (rise < 0) {
      down = true; // at 45 degrees
      EXPECT_NEAR(path[i].feed, 200 * std::sqrt(2.0), 0.01);
    }
    else {
      (rise > 0 ? up : level) = true;
      EXPECT_FLOAT_EQ(path[i].feed, 900);
    }
  }
  EXPECT_TRUE(down && level && up);
}

TEST_F(Linking, ALabelThatComesBackIsAPassOfItsOwn)
{
  CLCloud passes;
  addPass(passes, 0, {{5, 5, -1}, {9, 5, -1}});
  addPass(passes, 1, {{15, 5, -1}, {19, 5, -1}});
  addPass(passes, 0, {{5, 12, -1}, {9, 12, -1}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(linker.getReport().get("passes"), 3);
  EXPECT_EQ(linker.getReport().get("retracts"), 3);
}

TEST_F(Linking, OnlyTheIndicesGivenAreLinked)
{
  CLCloud passes;
  addPass(passes, 0, {{5, 5, -1}, {9, 5, -1}});
  addPass(passes, 1, {{15, 5, -1}, {19, 5, -1}});
  linker.setIndices(pcl::IndicesPtr(new pcl::Indices{2, 3}));
  for (const auto& p : link(linker, passes))
    EXPECT_GE(p.x, 15.f);
}

TEST_F(Linking, WithoutAStockRapidsStopAboveThePass)
{
  LinkPasses blind;
  blind.setTool(tool);
  blind.setCutting(cutting);
  blind.setClearancePlane(8);
  CLCloud passes;
  addPass(passes, 0, {{5, 5, -1}, {9, 5, -1}});
  const auto path = link(blind, passes);
  expectSound(path, 8, cutting, 3);
  for (const auto& p : path)
    if (isRapid(p)) {
      EXPECT_GE(p.z, 0.f);
    }
}
