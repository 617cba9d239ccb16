// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Rest roughing: what is worth a second, smaller tool.
#include "rough_test.h"

using namespace rough_test;

namespace {

template <typename S>
class RestRoughing : public EveryRoughing<S> {
protected:
  const Rectangle area{0, 0, 40, 30}, slot{16, 5, 24, 25}; // 8 wide, 5 deep
  const Cloud::Ptr cloud = surface(area, 0.25, [this](double x, double y) {
    return slot.inner(0.01).holds(x, y) ? -6.0 : -1.0;
  });
  const CellCloud::Ptr map = mapOf(cloud, 0.4);
  const std::shared_ptr<StockField> stock = block(area, -6, 0);

  /// What a flat end mill of 10 mm leaves: too wide for the slot.
  void roughWithTheLargeTool()
  {
    this->set(Tool::flat(1, 10), 0.3, 0.25, 4);
    this->roughing.setFloor(-6);
    this->roughing.setStock(stock);
    this->roughing.setPart(indexOf(*cloud));
    const auto passes = this->run(map);
    const Tool tool = this->roughing.getTool();
    forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
      EXPECT_GT(a.z(), -1);
      stock->cut(tool, a, b);
    });
  }
};
TYPED_TEST_SUITE(RestRoughing, Strategies, StrategyNames);

} // namespace

TYPED_TEST(RestRoughing, ClearsTheSlotThatOnlyTheSmallToolFitsAndNothingElse)
{
  this->roughWithTheLargeTool();
  const Tool small = Tool::flat(2, 4);
  this->set(small, 0.3, 0.5, 1.6);
  this->roughing.setRestLimits(1.0, 0.0);
  const auto passes = this->run(this->map);
  ASSERT_FALSE(passes.empty());
  const double whole =
      this->kLevel ? 0.0 : small.diameter; // the grid's moves are cells
  for (const auto& p : passes)
    EXPECT_LT(this->slot.distance(p.x, p.y), small.radius() + 0.8 + whole)
        << p.x << " " << p.y;
  StockField after = *this->stock;
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    after.cut(small, a, b);
  });
  for (double y = 9; y <= 21; y += 0.5)
    EXPECT_LE(after.highest(20, y, 0.5), -5.0) << y;
}

TYPED_TEST(RestRoughing, StockThinnerThanTheLimitIsLeft)
{
  // Half a millimetre all over a plate, 0.3 of it above the allowance.
  const auto plate = surface({0, 0, 30, 30}, 0.4, [](double, double) { return -0.5; });
  const auto plate_map = mapOf(plate, 0.4);
  this->set(Tool::flat(1, 6), 0.2, 0.1, 2);
  this->roughing.setStock(block({0, 0, 30, 30}, -2, 0));
  this->roughing.setPart(indexOf(*plate));
  EXPECT_FALSE(this->run(plate_map).empty());
  this->roughing.setRestLimits(0.2, 0.0);
  EXPECT_FALSE(this->run(plate_map).empty());
  this->roughing.setRestLimits(0.6, 0.0);
  EXPECT_TRUE(this->run(plate_map).empty());
}

TYPED_TEST(RestRoughing, ASkinNarrowerThanTheLimitIsLeft)
{
  // Round a tower 6 mm high stands a skin of 2 mm, and all else is gone.
  const Rectangle tower{15, 10, 25, 20};
  const auto part = surface(this->area, 0.25, [&](double x, double y) {
    return tower.holds(x, y) ? 0.0 : -6.0;
  });
  const auto skin = block(this->area, -6, 0, 0.2);
  const Tool wide = Tool::flat(1, 6);
  const double off = 2 + 3; // the axis so far from the tower
  for (double out = off; out < 24; out += 2) {
    const Rectangle way = tower.inner(-out);
    const Eigen::Vector3d corners[] = {{way.x0, way.y0, -5.7},
                                       {way.x1, way.y0, -5.7},
                                       {way.x1, way.y1, -5.7},
                                       {way.x0, way.y1, -5.7}};
    for (int i = 0; i < 4; ++i)
      skin->cut(wide, corners[i], corners[(i + 1) % 4]);
  }
  this->set(Tool::flat(2, 4), 0.2, 1.0, 1.6);
  this->roughing.setFloor(-5.7);
  this->roughing.setStock(skin);
  this->roughing.setPart(indexOf(*part));
  const auto part_map = mapOf(part, 0.4);
  this->roughing.setRestLimits(1.0, 0.0);
  EXPECT_FALSE(this->run(part_map).empty());
  this->roughing.setRestLimits(1.0, 4.0);
  EXPECT_TRUE(this->run(part_map).empty());
}
