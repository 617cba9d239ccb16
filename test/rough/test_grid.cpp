// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What is the grid method's own: rows and cells where paper 000 puts them, up and
// aside.
#include "rough_test.h"

#include <set>

using namespace rough_test;

namespace {

class Grid : public EveryRoughing<GridRoughing> {
protected:
  const Rectangle area{0, 0, 50, 40};
  const Tool tool = Tool::flat(1, 8);

  CLCloud rough(const Cloud::Ptr& cloud, double allowance, double step_down, double top)
  {
    this->set(tool, allowance, step_down, 3.2);
    this->roughing.setStock(block(area, -1, top));
    this->roughing.setPart(indexOf(*cloud));
    this->roughing.setFloor(0.0);
    return this->run(mapOf(cloud, 0.4));
  }
};

} // namespace

TEST_F(Grid, RowsLieWhereThePaperPutsThem)
{
  // A plate far below: one level, nothing in the way. Cells of 2R - 0.5 delta from
  // y_min + 0.5 delta and x_min - 0.5 delta on; z_max - the depth of cut.
  const auto plate = surface(area, 0.5, [](double, double) { return -1.0; });
  for (const double delta : {0.4, 0.8}) { // with none, rows touch and leave ridges
    const auto passes = this->rough(plate, delta, 2.0, 2.0);
    const double cell = 8 - 0.5 * delta;
    EXPECT_DOUBLE_EQ(this->roughing.cellSize(), cell);
    std::set<float> rows, columns;
    for (const auto& p : passes) {
      rows.insert(p.y);
      columns.insert(p.x);
      EXPECT_EQ(p.z, 0.f);
    }
    ASSERT_GE(rows.size(), 5u);
    int k = 0;
    for (const float y : rows)
      EXPECT_FLOAT_EQ(y, float(0.5 * delta + cell * k++));
    // At both ends it overruns the free boundary by the radius.
    EXPECT_FLOAT_EQ(*columns.begin(), -4.f);
    EXPECT_FLOAT_EQ(*columns.rbegin(), 54.f);
    k = 0;
    for (const float x : columns)
      if (x != *columns.begin() && x != *columns.rbegin()) {
        EXPECT_FLOAT_EQ(x, float(-0.5 * delta + cell * k++));
      }
    EXPECT_GE(k, 6);
    EXPECT_EQ(passes.back().label, 0u) << "forth and back in one pass";
    EXPECT_EQ(this->roughing.getReport().get("missed_mm2"), 0);
  }
}

TEST_F(Grid, GoesUpOverWhatRisesLessThanAStepDown)
{
  // A low ridge across all rows, 1.2 mm above the level and its allowance below the
  // next.
  const auto part = surface(
      area, 0.4, [](double x, double) { return x > 22 && x < 24 ? 1.2 : -1.0; });
  const auto passes = this->rough(part, 0.5, 2.0, 2.0);
  int above = 0, below = 0;
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    above += a.z() == b.z() && std::abs(a.z() - 1.7) < 0.1;
    below += a.z() == 0 && b.z() == 0;
    const double down = a.z() - b.z(), along = (b - a).template head<2>().norm();
    EXPECT_LE(down, 0.5 * along + 1e-6) << "sinks at " << a.transpose();
  });
  EXPECT_GE(above, 5) << "each row goes over";
  EXPECT_GE(below, 10);
  EXPECT_GE(this->clearance(passes, tool, pointsOf(*part)), 0.5 - 1e-3);
}

TEST_F(Grid, GoesAsideOfWhatIsHigher)
{
  const Rectangle tower{20, 0, 28, 40}; // from edge to edge: two sides
  const auto part = surface(
      area, 0.4, [&](double x, double y) { return tower.holds(x, y) ? 6.0 : -1.0; });
  const auto passes = this->rough(part, 0.5, 2.0, 6.0);
  ASSERT_FALSE(passes.empty());
  std::set<bool> sides;
  for (const auto& p : passes) {
    EXPECT_GE(tower.distance(p.x, p.y), 4.499) << p.x << " " << p.y;
    sides.insert(p.x < 24);
  }
  EXPECT_EQ(sides.size(), 2u) << "begins anew beyond it";
}

TEST_F(Grid, ACellDoesNotDecideHowNearItGets)
{
  // The wall at x = 30.3 lies within a cell of 7.75 mm; what the cell leaves before it
  // is cut up to the allowance and a node.
  const auto part =
      surface(area, 0.3, [](double x, double) { return x >= 30.3 ? 5.0 : -1.0; });
  const auto passes = this->rough(part, 0.5, 1.0, 5.0);
  double nearest = -100;
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    if (std::min(a.y(), b.y()) < 30 && std::max(a.y(), b.y()) > 10)
      nearest = std::max(nearest, std::min(a.x(), b.x()));
  });
  EXPECT_LE(nearest, 30.3 - 4.5 + 1e-3);
  EXPECT_GE(nearest, 30.3 - 4.5 - 0.9);
}

TEST_F(Grid, RefusesAnAllowanceThatLeavesNoCell)
{
  const auto plate = surface(area, 0.5, [](double, double) { return -1.0; });
  EXPECT_THROW(this->rough(plate, 15.0, 2.0, 2.0), ParameterError);
}
