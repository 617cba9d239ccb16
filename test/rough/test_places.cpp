// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Flats get levels of their own; what is too narrow or kept out of is named.
#include "rough_test.h"

using namespace rough_test;

namespace {

template <typename S>
class RoughingPlaces : public EveryRoughing<S> {
};
TYPED_TEST_SUITE(RoughingPlaces, Strategies, StrategyNames);

std::set<float> heightsOf(const CLCloud& passes)
{
  std::set<float> heights;
  for (const auto& p : passes)
    heights.insert(p.z);
  return heights;
}

} // namespace

TYPED_TEST(RoughingPlaces, AFlatGetsItsLevelWhereItIsAndNowhereElse)
{
  // A terrace at -2.5 beside a base at -6: levels at -1, -2, ... and one at -2.5 + 0.2.
  const Rectangle area{0, 0, 50, 40}, terrace{0, 0, 24, 40};
  const auto cloud = surface(
      area, 0.4, [&](double x, double y) { return terrace.holds(x, y) ? -2.5 : -6.0; });
  this->set(Tool::flat(1, 6), 0.2, 1.0, 2.4);
  this->roughing.setFloor(-5.5);
  this->roughing.setMinFlat(100);
  this->roughing.setPart(indexOf(*cloud));
  const auto stock = block(area, -6, 0);
  this->roughing.setStock(stock);
  const auto passes = this->run(mapOf(cloud, 0.4));
  EXPECT_EQ(this->roughing.getReport().get("levels_on_flats"), 1);
  const auto heights = heightsOf(passes);
  double flat = 0;
  for (const float z : heights)
    if (std::abs(z + 2.3) < 0.1)
      flat = z;
  ASSERT_LT(flat, 0) << "no level on the terrace";
  EXPECT_GE(flat, -2.3 - 1e-4) << "the allowance is kept";
  EXPECT_LE(flat, -2.3 + 0.02);
  for (const auto& p : passes)
    if (p.z == float(flat) && p.getMotion() == Motion::Cut) {
      EXPECT_LE(p.x, 24 + 7.5) << "the base is left to its own levels";
    }
  forCells(simulate(passes, Tool::flat(1, 6), stock->stock(), 0.25),
           [&](double x, double y, double h) {
             if (terrace.inner(1).holds(x, y)) {
               EXPECT_FLOAT_EQ(h, float(flat)) << x << " " << y;
             }
           });
}

TYPED_TEST(RoughingPlaces, AReliefHasNoFlats)
{
  // Smooth ground, slopes and the quantised heights of a depth map must not be taken
  // for hundreds of flats: never more than one between two levels.
  const Rectangle area{0, 0, 40, 40};
  const Bumps bumps(area, 8.0, 9, 5);
  this->set(Tool::flat(1, 5), 0.2, 1.0, 2.0);
  this->roughing.setMinFlat(25);
  const auto flatsOf = [&](const Cloud::Ptr& cloud) {
    this->roughing.setPart(indexOf(*cloud));
    this->run(mapOf(cloud, 0.4));
    return this->roughing.getReport().get("levels_on_flats");
  };
  EXPECT_EQ(flatsOf(surface(area, 0.4, [](double x, double) { return 0.3 * x; })), 0);
  const auto steps = surface(area, 0.4, [&](double x, double y) {
    return 0.05 * std::round(bumps(x, y) / 0.05);
  });
  EXPECT_LE(flatsOf(steps), this->roughing.getReport().get("levels") / 2);
}

TYPED_TEST(RoughingPlaces, APocketNarrowerThanTheToolIsNamed)
{
  const Rectangle area{0, 0, 40, 40}, pocket{10, 10, 15, 30};
  const auto cloud = surface(area, 0.25, [&](double x, double y) {
    return pocket.inner(0.01).holds(x, y) ? -4.0 : 0.0;
  });
  this->set(Tool::flat(1, 6), 0.2, 0.5, 2.4);
  this->roughing.setStock(block(area, -5, 1));
  this->roughing.setPart(indexOf(*cloud));
  this->run(mapOf(cloud, 0.25));
  const auto& places = this->roughing.getNarrowPlaces();
  ASSERT_EQ(places.size(), 1u);
  EXPECT_TRUE(pocket.holds(places[0].at.x(), places[0].at.y()));
  EXPECT_NEAR(places[0].at.z(), -3.8, 1e-4);
  EXPECT_NEAR(places[0].area, 5 * 20, 2 * 25 * 0.5) << "to a cell or two";
  EXPECT_NEAR(places[0].volume, 5 * 20 * 4, 4 * 2 * 25 * 0.5);
}

TYPED_TEST(RoughingPlaces, ABoxHasNoPlaceOutOfReach)
{
  const Rectangle area{0, 0, 50, 40}, box{15, 12, 34, 27};
  const auto cloud = surface(
      area, 0.4, [&](double x, double y) { return box.holds(x, y) ? 0.0 : -6.0; });
  this->set(Tool::flat(1, 6), 0.3, 1.0, 2.4);
  this->roughing.setStock(block(area, -6, 0));
  this->roughing.setPart(indexOf(*cloud));
  this->run(mapOf(cloud, 0.4));
  EXPECT_TRUE(this->roughing.getNarrowPlaces().empty());
  EXPECT_EQ(this->roughing.getReport().get("kept_out_mm3"), 0);
  // Constant engagement leaves skins of less than a cell's part on round corners.
  EXPECT_LE(this->roughing.getReport().get("missed_mm2"), 2.0);
}

TYPED_TEST(RoughingPlaces, ZonesAreKeptOutOfAndWhatStaysIsSaid)
{
  const Rectangle area{0, 0, 60, 50};
  const auto cloud = surface(area, 0.5, [](double, double) { return -4.0; });
  const KeepOut zones({KeepOutZone::cylinder(30, 25, 6, 8)}, 1.0);
  const Tool tool = Tool::flat(1, 8);
  this->set(tool, 0.2, 1.0, 3.2);
  this->roughing.setStock(block(area, -4, 0));
  this->roughing.setPart(indexOf(*cloud));
  this->roughing.setKeepOut(zones);
  const auto map = mapOf(cloud, 0.4);
  const auto passes = this->run(map);
  ASSERT_FALSE(passes.empty());
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    EXPECT_EQ(zones.depth(tool, a, b), 0) << b.transpose();
  });
  // A disc of the zone's and the margin's radius stands, 4 mm less the allowance high.
  const double kept = this->roughing.getReport().get("kept_out_mm3");
  EXPECT_NEAR(kept, M_PI * 7 * 7 * 3.8, 2 * M_PI * 7 * 0.8 * 3.8);
  this->roughing.setKeepOut({});
  this->run(map);
  EXPECT_EQ(this->roughing.getReport().get("kept_out_mm3"), 0);
}
