// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// In the order of the passes no layer is taken that is thicker than the step-down.
#include "rough_test.h"

using namespace rough_test;

namespace {

/// Seen from above, less than a cell of the map [mm2] is a splinter.
constexpr double kSplinter = 0.4 * 0.4;

template <typename S>
class RoughingDepth : public EveryRoughing<S> {
protected:
  /// The thickest layer that a pass takes from a place [mm].
  double deepestCut(const CLCloud& passes, const StockField& stock) const
  {
    StockField field = stock;
    double deepest = 0;
    forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
      const Cut cut = field.cut(this->roughing.getTool(), a, b);
      if (cut.volume > cut.depth * kSplinter)
        deepest = std::max(deepest, cut.depth);
    });
    return deepest;
  }
};
TYPED_TEST_SUITE(RoughingDepth, Strategies, StrategyNames);

StockField nominal(const Rectangle& area, double bottom, double top)
{
  return StockField({{area.x0, area.y0, bottom}, {area.x1, area.y1, top}},
                    0.25,
                    StockField::Bound::Nominal);
}

/// Cuts all of both fields down to `z` but for the islands, which keep their heights.
struct Island {
  Rectangle place;
  double height;
};
void leaveIslands(StockField& field,
                  const Rectangle& area,
                  double z,
                  const std::vector<Island>& islands)
{
  const Tool fine = Tool::flat(9, 1.0);
  for (double y = area.y0; y <= area.y1; y += 0.25)
    for (double x = area.x0; x <= area.x1; x += 0.25) {
      double top = z;
      for (const auto& island : islands)
        if (island.place.distance(x, y) <= 0.5)
          top = std::max(top, island.height);
      field.cut(fine, Eigen::Vector3d(x, y, 99), Eigen::Vector3d(x, y, top));
    }
}

} // namespace

TYPED_TEST(RoughingDepth, OfOneBlockIsTheStepDown)
{
  const Rectangle area{0, 0, 36, 28};
  for (std::uint64_t seed : {61, 62, 63}) {
    const auto cloud = surface(area, 0.4, Bumps(area, 6, 12, seed));
    this->set(Tool::flat(1, 5), 0.2, 1.0, 2.0);
    this->roughing.setStock(block(area, -1, 6));
    this->roughing.setPart(indexOf(*cloud));
    const auto passes = this->run(mapOf(cloud, 0.4));
    // Splinters of a cell may stand until the next level.
    EXPECT_LE(this->deepestCut(passes, nominal(area, -1, 6)), 2.0 + 1e-4) << seed;
  }
}

TYPED_TEST(RoughingDepth, OfSeparateIslandsIsTheStepDown)
{
  // Stock that earlier operations left in places, each of its own height, over a flat
  // part: between them the tool can go on the level.
  const Rectangle area{0, 0, 60, 44};
  const auto cloud = surface(area, 0.5, [](double, double) { return 0; });
  const auto index = indexOf(*cloud);
  const auto map = mapOf(cloud, 0.4);
  for (std::uint64_t seed = 71; seed < 83; ++seed) {
    Random random(seed);
    std::vector<Island> islands;
    for (int i = 0; i < 5; ++i) {
      const double x = random.uniform(0, 50), y = random.uniform(0, 36);
      islands.push_back({{x, y, x + random.uniform(2, 10), y + random.uniform(2, 8)},
                         random.uniform(2, 8)});
    }
    const auto stock = block(area, -1, 8);
    leaveIslands(*stock, area, 0.3, islands);
    StockField truth = nominal(area, -1, 8);
    leaveIslands(truth, area, 0.3, islands);
    this->set(Tool::flat(1, 5), 0.2, 1.0, 2.0);
    this->roughing.setFloor(0.5);
    this->roughing.setStock(stock);
    this->roughing.setPart(index);
    const auto passes = this->run(map);
    ASSERT_FALSE(passes.empty());
    EXPECT_LE(this->deepestCut(passes, truth), 1.2) << seed;
  }
}

TYPED_TEST(RoughingDepth, RegionsWithoutCommonStockAreFinishedOneByOne)
{
  // Two pockets far apart in a plate: down to the floor in one, then in the other.
  const Rectangle area{0, 0, 60, 30}, left{5, 5, 20, 25}, right{40, 5, 55, 25};
  const auto cloud = surface(area, 0.4, [&](double x, double y) {
    return left.holds(x, y) || right.holds(x, y) ? -5.0 : 0.0;
  });
  this->set(Tool::flat(1, 5), 0.2, 1.0, 2.0);
  this->roughing.setFloor(-4.5);
  this->roughing.setStock(block(area, -5, 0));
  this->roughing.setPart(indexOf(*cloud));
  const auto passes = this->run(mapOf(cloud, 0.4));
  ASSERT_FALSE(passes.empty());
  int changes = 0;
  for (std::size_t i = 1; i < passes.size(); ++i) {
    const bool changed = (passes[i].x < 30) != (passes[i - 1].x < 30);
    changes += changed;
    if (changed) {
      EXPECT_NE(passes[i].label, passes[i - 1].label);
    }
    else {
      EXPECT_GE(passes[i].level, passes[i - 1].level);
    }
  }
  EXPECT_EQ(changes, 1);
  EXPECT_LE(this->deepestCut(passes, nominal(area, -5, 0)), 1.0 + 1e-4);
}
