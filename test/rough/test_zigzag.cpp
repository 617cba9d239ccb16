// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What is the zig-zag's own: regions, their order, and the tool that stays down.
#include "rough_test.h"

#include <stdexcept>

using namespace rough_test;

namespace {

class ZigZag : public EveryRoughing<ZigZagRoughing> {
protected:
  const Rectangle area{0, 0, 80, 60};
  const Tool tool = Tool::flat(1, 6);

  /// One level of a block 1 mm deep round a part that stands where `inside` says.
  template <typename Inside>
  CLCloud oneLevel(Inside&& inside)
  {
    const auto cloud = surface(
        area, 0.4, [&](double x, double y) { return inside(x, y) ? 0.0 : -1.0; });
    this->set(tool, 0.2, 1.0, 2.4);
    this->roughing.setFloor(-0.7);
    this->roughing.setStock(block(area, -1, 0));
    this->roughing.setPart(indexOf(*cloud));
    const auto passes = this->run(mapOf(cloud, 0.4));
    if (passes.empty())
      throw std::logic_error("nothing was milled");
    return passes;
  }
  double figure(const char* name) { return this->roughing.getReport().get(name, -1); }
};

} // namespace

TEST_F(ZigZag, AnEmptyLevelIsOneRegionAndOnePass)
{
  const auto passes = this->oneLevel([](double, double) { return false; });
  EXPECT_EQ(passes.back().label, 0u);
  EXPECT_EQ(figure("regions"), 1);
  // Only the ways from row to row, which are the same in either order.
  EXPECT_NEAR(figure("air_mm"), figure("air_before_mm"), 1e-6);
  EXPECT_LE(figure("air_mm"), 60 + 2 * 6 + 2 * 2.4);
}

TEST_F(ZigZag, RowsAreCutOnceAndInTurn)
{
  const auto passes = this->oneLevel([](double, double) { return false; });
  int rows = 0;
  double y = passes.front().y;
  const double sign = passes.back().y > y ? 1 : -1;
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    if ((b - a).norm() > 40) { // along a row, from one end of the stock to the other
      EXPECT_EQ(a.y(), b.y());
      EXPECT_TRUE(rows == 0 || sign * (a.y() - y) > 2) << a.y();
      y = a.y();
      ++rows;
    }
  });
  EXPECT_GE(rows, 25);
  EXPECT_LE(rows, 32);
}

TEST_F(ZigZag, AnIslandMakesFourRegionsBetweenWhichTheToolStaysDown)
{
  // Before it, on its near side, on its far side and behind it: the tool gets round.
  const Rectangle island{30, 22, 50, 38};
  const auto passes =
      this->oneLevel([&](double x, double y) { return island.holds(x, y); });
  EXPECT_EQ(figure("regions"), 4);
  EXPECT_LE(passes.back().label, 2u) << "with what is left beside the island's walls";
  EXPECT_LT(figure("air_mm"), 0.5 * figure("air_before_mm"));
}

TEST_F(ZigZag, ABayThatSeparatesNothingMakesNoRegion)
{
  // A C, open to the left: its hull is the square, the rows run right into the bay.
  const Rectangle square{30, 16, 70, 44}, bay{29, 24, 50, 36};
  this->oneLevel([&](double x, double y) {
    return square.holds(x, y) && !bay.inner(0.01).holds(x, y);
  });
  EXPECT_EQ(figure("regions"), 4); // below, before it with the bay, behind it, above
}

TEST_F(ZigZag, WhatCannotBeReachedOnTheLevelIsAPassOfItsOwn)
{
  // A wall from edge to edge and beyond the tool's reach round it.
  const auto cloud = [&](double x, double) { return x > 38 && x < 42; };
  const auto passes = this->oneLevel(cloud);
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    const bool outside = a.y() < -3 || a.y() > 63;
    EXPECT_TRUE((a.x() < 40) == (b.x() < 40) || outside) << "through the wall";
  });
  EXPECT_EQ(figure("regions"), 2);
}

TEST_F(ZigZag, AirOnManyIslandsIsLessAndTheWayIsProven)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    std::vector<Rectangle> islands;
    for (int i = 0; i < 12; ++i) {
      const double x = random.uniform(0, 74), y = random.uniform(0, 54);
      islands.push_back({x, y, x + random.uniform(1, 9), y + random.uniform(1, 9)});
    }
    const auto inside = [&](double x, double y) {
      for (const auto& island : islands)
        if (island.holds(x, y))
          return true;
      return false;
    };
    const auto passes = this->oneLevel(inside);
    EXPECT_LT(figure("air_mm"), 0.7 * figure("air_before_mm")) << seed;
    const auto cloud = surface(
        area, 0.4, [&](double x, double y) { return inside(x, y) ? 0.0 : -1.0; });
    EXPECT_GE(this->clearance(passes, tool, pointsOf(*cloud)), 0.2 - 1e-3) << seed;
  }
}
