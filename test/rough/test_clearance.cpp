// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// No pass comes nearer to the part than the allowance.
#include "rough_test.h"

using namespace rough_test;

namespace {

constexpr Rectangle kArea{0, 0, 36, 28};

Cloud::Ptr bumpyPart(std::uint64_t seed)
{
  const Bumps bumps(kArea, 9.0, 14, seed);
  Cloud::Ptr cloud = surface(kArea, 0.4, bumps);
  Random random(seed + 100); // points lie anywhere in their cells
  for (auto& p : *cloud) {
    p.x += float(random.uniform(-0.2, 0.2));
    p.y += float(random.uniform(-0.2, 0.2));
    p.z = float(bumps(p.x, p.y) + 0.02 * random.normal());
  }
  return cloud;
}

template <typename S>
class RoughingClearance : public EveryRoughing<S> {
};
TYPED_TEST_SUITE(RoughingClearance, Strategies, StrategyNames);

} // namespace

TYPED_TEST(RoughingClearance, TheAllowanceIsLeftOverTheMapsCells)
{
  const Tool tool = Tool::flat(1, 6);
  for (std::uint64_t seed : {1, 2}) {
    const auto cloud = bumpyPart(seed);
    this->set(tool, 0.4, 1.3, 2.4);
    this->roughing.setStock(block({-4, -4, 40, 32}, -2, 10));
    const auto passes = this->run(mapOf(cloud, 0.5));
    ASSERT_GT(passes.size(), 200u);
    EXPECT_GE(this->clearance(passes, tool, pointsOf(*cloud)), 0.4 - 1e-3) << seed;
  }
}

TYPED_TEST(RoughingClearance, TheAllowanceIsLeftOnThePartsPoints)
{
  for (const Tool& tool : {Tool::flat(1, 6),
                           Tool::ball(2, 5),
                           Tool::bull(3, 6, 1),
                           Tool::taperBall(4, 3, 8, 6),
                           Tool::cone(5, 30, 6, 2)}) {
    const auto cloud = bumpyPart(3);
    this->set(tool, 0.4, 1.3, 2.0);
    this->roughing.setPart(indexOf(*cloud));
    this->roughing.setStock(block({-4, -4, 40, 32}, -2, 10));
    const auto passes = this->run(mapOf(cloud, 0.5));
    ASSERT_GT(passes.size(), 200u);
    const double least = this->clearance(passes, tool, pointsOf(*cloud));
    EXPECT_GE(least, 0.4 - 1e-3) << tool.describe();
    EXPECT_LE(least, 0.45) << tool.describe() << ": nowhere near the part";
  }
}

TYPED_TEST(RoughingClearance, CoarseCellsNeverGougeThePart)
{
  // Cells as wide as the radius of the cutter's end, or more, where moves between nodes
  // round it most.
  const auto cloud = bumpyPart(4);
  for (const Tool& tool : {Tool::flat(1, 4), Tool::taperBall(2, 2, 10, 8)})
    for (const bool exact : {false, true}) {
      this->set(tool, 0.0, 1.0, 2.0);
      this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
      this->roughing.setStock(block({-4, -4, 40, 32}, -2, 10));
      const auto passes = this->run(mapOf(cloud, 2.0));
      ASSERT_GT(passes.size(), 50u);
      EXPECT_GE(this->clearance(passes, tool, pointsOf(*cloud)), -1e-3)
          << tool.describe() << exact;
    }
}

TYPED_TEST(RoughingClearance, AThinPinIsGoneRound)
{
  // One column of points, high up, in the middle of a plate.
  Cloud::Ptr cloud = surface({0, 0, 20, 20}, 0.5, [](double, double) { return 0; });
  for (double z = 0.5; z <= 8; z += 0.5)
    cloud->push_back(pcl::PointXYZ(10.1f, 9.9f, float(z)));
  const Tool tool = Tool::flat(1, 5);
  this->set(tool, 0.2, 1.0, 2.0);
  const auto stock = block({0, 0, 20, 20}, -1, 8);
  this->roughing.setStock(stock);
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto passes = this->run(mapOf(cloud, 0.5));
    EXPECT_GE(this->clearance(passes, tool, pointsOf(*cloud)), 0.2 - 1e-3);
    const auto left = simulate(passes, tool, stock->stock(), 0.25);
    forCells(left, [&](double x, double y, double h) {
      const double d = std::hypot(x - 10.1, y - 9.9);
      if (d > 2.0) {
        EXPECT_LE(h, 1.5) << x << " " << y;
      }
      if (d < 0.19) {
        EXPECT_EQ(h, 8.0) << x << " " << y;
      }
    });
  }
}

TYPED_TEST(RoughingClearance, TowersCloserThanTheToolAreNotEnteredBetween)
{
  const Rectangle left{10, 10, 18, 20}, right{23, 10, 31, 20}; // 5 mm between
  const auto cloud = surface({0, 0, 41, 30}, 0.5, [&](double x, double y) {
    return left.holds(x, y) || right.holds(x, y) ? 6.0 : 0.0;
  });
  const Tool tool = Tool::flat(1, 6);
  this->set(tool, 0.3, 1.0, 2.4);
  const auto stock = block({0, 0, 41, 30}, -1, 6);
  this->roughing.setStock(stock);
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto passes = this->run(mapOf(cloud, 0.25));
    ASSERT_FALSE(passes.empty());
    forMovesOfPasses(passes, [&](const auto&, const auto& b, const PointCL&) {
      EXPECT_FALSE(b.x() > 18 && b.x() < 23 && b.y() > 10 && b.y() < 20);
    });
    const auto field = simulate(passes, tool, stock->stock(), 0.25);
    // Grown by the allowance, the round cutter looks 0.85 mm in at the gap's mouths.
    const double look_in = 3 - std::sqrt(3.3 * 3.3 - 2.5 * 2.5);
    const Rectangle between{18, 10 + look_in, 23, 20 - look_in};
    forCells(field, [&](double x, double y, double h) {
      if (left.holds(x, y) || right.holds(x, y) || between.holds(x, y)) {
        EXPECT_EQ(h, 6.0) << x << " " << y;
      }
    });
    EXPECT_GT(volumeRemoved(field), 3000);
  }
}

TYPED_TEST(RoughingClearance, APocketNarrowerThanTheToolIsNotEntered)
{
  const Rectangle pocket{10, 10, 15, 30};
  const auto cloud = surface({0, 0, 25, 40}, 0.5, [&](double x, double y) {
    return pocket.inner(0.01).holds(x, y) ? -4.0 : 0.0;
  });
  const Tool tool = Tool::flat(1, 6);
  this->set(tool, 0.3, 0.5, 2.4);
  const auto stock = block({0, 0, 25, 40}, -5, 1);
  this->roughing.setStock(stock);
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto passes = this->run(mapOf(cloud, 0.5));
    const auto field = simulate(passes, tool, stock->stock(), 0.25);
    forCells(field, [&](double x, double y, double h) {
      EXPECT_EQ(h, 0.5) << x << " " << y; // one level, all over
    });
  }
}
