// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// All that the tool can get at is cut, and nothing else.
#include "rough_test.h"

using namespace rough_test;

namespace {

template <typename S>
class RoughingCoverage : public EveryRoughing<S> {
};
TYPED_TEST_SUITE(RoughingCoverage, Strategies, StrategyNames);

double grownArea(double a, double b, double by)
{
  return a * b + 2 * (a + b) * by + M_PI * by * by;
}

/// The height down to which `tool` can cut at (x, y) while it keeps `allowance` from
/// all points and stands at one of the levels: by trying many places for its axis.
/// A flat end is meant.
class Reach {
public:
  Reach(const brute::Points& points,
        const Rectangle& area,
        const Tool& tool,
        double allowance,
        double step)
      : area_(area), step_(step)
  {
    const Tool grown = tool.grown(allowance);
    columns_ = static_cast<std::size_t>((area.x1 - area.x0) / step) + 1;
    const auto rows = static_cast<std::size_t>((area.y1 - area.y0) / step) + 1;
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns_; ++i)
        lowest_.push_back(
            brute::drop(
                points, grown, area.x0 + double(i) * step, area.y0 + double(j) * step) +
            allowance);
  }
  double lowestOver(double x, double y, double within) const
  {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < lowest_.size(); ++k) {
      const double cx = area_.x0 + double(k % columns_) * step_;
      const double cy = area_.y0 + double(k / columns_) * step_;
      if (std::hypot(cx - x, cy - y) <= within)
        best = std::min(best, lowest_[k]);
    }
    return best;
  }

private:
  Rectangle area_;
  double step_;
  std::size_t columns_;
  std::vector<double> lowest_;
};

} // namespace

TYPED_TEST(RoughingCoverage, ABoxIsFreedFromALargerBlock)
{
  const Rectangle box{0, 0, 20, 14};
  const auto cloud = surface(box, 0.25, [](double, double) { return 0; });
  const auto stock = block({-12, -15, 33, 31}, -8, 0);
  const Tool tool = Tool::flat(1, 6);
  const double cell = 0.5, allowance = 0.5;
  for (const bool exact : {false, true}) {
    this->set(tool, allowance, 1.5, 2.4);
    this->roughing.setFloor(-8);
    this->roughing.setStock(stock);
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto field =
        simulate(this->run(mapOf(cloud, cell)), tool, stock->stock(), 0.25);
    // Exact heights leave the allowance and what the nodes' grid costs; cells count as
    // full, and a move between nodes keeps off by half a diagonal more.
    const double most = allowance + (exact ? 1.0 : 2.5) * std::sqrt(2.0) * cell;
    forCells(field, [&](double x, double y, double h) {
      const double d = box.distance(x, y);
      if (d > most) {
        EXPECT_FLOAT_EQ(h, -8) << x << " " << y;
      }
      else if (d <= allowance) {
        EXPECT_EQ(h, 0) << x << " " << y;
      }
    });
    const double stock_area = 45 * 46, fuzz = 2 * (20 + 14 + 4 * most) * 0.25 / 2;
    EXPECT_GE(volumeRemoved(field), 8 * (stock_area - grownArea(20, 14, most) - fuzz));
    EXPECT_LE(volumeRemoved(field),
              8 * (stock_area - grownArea(20, 14, allowance) + fuzz));
  }
}

TYPED_TEST(RoughingCoverage, ARingIsClearedInsideAndOutside)
{
  const auto radius = [](double x, double y) { return std::hypot(x - 26, y - 26); };
  const Rectangle area{0, 0, 52, 52};
  const auto cloud = surface(area, 0.4, [&](double x, double y) {
    const double r = radius(x, y);
    return r >= 9 && r <= 15 ? 0.0 : -6.0;
  });
  const auto stock = block(area, -6, 0);
  const Tool tool = Tool::flat(1, 6);
  const double cell = 0.4, slack = 0.3 + 0.4 + 2.5 * std::sqrt(2.0) * cell;
  for (const bool exact : {false, true}) {
    this->set(tool, 0.3, 1.0, 2.4);
    this->roughing.setFloor(-5.5);
    this->roughing.setStock(stock);
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto field =
        simulate(this->run(mapOf(cloud, cell)), tool, stock->stock(), 0.25);
    forCells(field, [&](double x, double y, double h) {
      const double r = radius(x, y);
      if (r >= 9 && r <= 15) {
        EXPECT_EQ(h, 0) << x << " " << y;
      }
      else if (r < 9 - slack || r > 15 + slack) {
        EXPECT_FLOAT_EQ(h, -5.5) << x << " " << y;
      }
    });
  }
}

TYPED_TEST(RoughingCoverage, AWideHoleAsideOfTheMiddleIsCleared)
{
  // The rows or contours that come from outside meet the ring, go round it or stop, and
  // must not forget what is within.
  const auto radius = [](double x, double y) { return std::hypot(x - 24, y - 22); };
  const Rectangle area{0, 0, 90, 60};
  const auto cloud = surface(area, 0.5, [&](double x, double y) {
    const double r = radius(x, y);
    return r >= 15 && r <= 18 ? 0.0 : -3.0;
  });
  const auto stock = block(area, -3, 0);
  const Tool tool = Tool::flat(1, 6);
  this->set(tool, 0.3, 1.0, 2.4);
  this->roughing.setFloor(-2.5);
  this->roughing.setStock(stock);
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto field =
        simulate(this->run(mapOf(cloud, 0.5)), tool, stock->stock(), 0.25);
    int inside = 0, outside = 0;
    forCells(field, [&](double x, double y, double h) {
      inside += radius(x, y) < 12.5 && h > -2.499;
      outside += radius(x, y) > 20.5 && h > -2.499;
    });
    EXPECT_EQ(inside, 0) << "cells of 0.0625 mm2";
    EXPECT_EQ(outside, 0) << "cells of 0.0625 mm2";
  }
}

TYPED_TEST(RoughingCoverage, NothingThatTheToolReachesIsLeft)
{
  const Rectangle area{0, 0, 24, 20};
  const Tool tool = Tool::flat(1, 4);
  const double cell = 0.25, allowance = 0.3;
  for (std::uint64_t seed : {11, 12, 13}) {
    const auto cloud = surface(area, 0.4, Bumps(area, 6.0, 9, seed));
    const auto stock = block(area, -1, 6);
    this->set(tool, allowance, 1.0, 1.6);
    this->roughing.setFloor(0.0);
    this->roughing.setStock(stock);
    this->roughing.setPart(indexOf(*cloud));
    const auto field =
        simulate(this->run(mapOf(cloud, cell)), tool, stock->stock(), 0.4);
    // The part keeps the tool off by a few cells more than it must.
    const double slack = 3 * cell;
    const Reach generous(
        pointsOf(*cloud), {-4, -4, 28, 24}, tool, allowance + slack, 0.4);
    int left = 0, deep = 0;
    forCells(field, [&](double x, double y, double h) {
      const double reached = generous.lowestOver(x, y, tool.radius() - slack);
      const double level = std::max(0.0, std::ceil(reached - 1e-6)); // 6, 5, ... 0
      left += h > level + 1e-3;
      deep += level < 4;
    });
    EXPECT_EQ(left, 0) << seed;
    EXPECT_GT(deep, 500) << seed;
  }
}

TYPED_TEST(RoughingCoverage, AWideStepOverLeavesNoPillars)
{
  // The step-over may be anything up to the tool's diameter; three quarters leave room
  // for the grid.
  const Rectangle box{0, 0, 6, 6};
  const auto cloud = surface(box, 0.25, [](double, double) { return 0; });
  const auto map = mapOf(cloud, 0.25);
  const Tool tool = Tool::flat(1, 8);
  for (const double share : {0.4, 0.55, 0.65, 0.75}) {
    this->set(tool, 0.2, 1.0, share * 8);
    this->roughing.setFloor(-1);
    this->roughing.setPart(indexOf(*cloud));
    int standing = 0;
    for (double length = 24; length < 40; length += 3.7) {
      const auto stock = block({-length, -30, 6, 6}, -1, 0);
      this->roughing.setStock(stock);
      const auto field = simulate(this->run(map), tool, stock->stock(), 0.25);
      forCells(field, [&](double x, double y, double h) {
        standing += box.distance(x, y) > 1.0 && h > -0.999;
      });
    }
    EXPECT_EQ(standing, 0) << "cells of 0.0625 mm2 with a step-over of " << share
                           << " d";
  }
}

TYPED_TEST(RoughingCoverage, APartAtTheStocksEdgeIsMilledOnItsOtherSides)
{
  const Rectangle area{0, 0, 30, 20}, box{0, 0, 12, 20}; // flush on three sides
  const auto cloud = surface(
      area, 0.4, [&](double x, double y) { return box.holds(x, y) ? 0.0 : -5.0; });
  const auto stock = block(area, -5, 0);
  const Tool tool = Tool::flat(1, 6);
  for (const bool exact : {false, true}) {
    this->set(tool, 0.3, 1.0, 2.4);
    this->roughing.setFloor(-4.5);
    this->roughing.setStock(stock);
    this->roughing.setPart(exact ? indexOf(*cloud) : nullptr);
    const auto field =
        simulate(this->run(mapOf(cloud, 0.4)), tool, stock->stock(), 0.25);
    forCells(field, [&](double x, double y, double h) {
      if (x < 12.3) {
        EXPECT_EQ(h, 0) << x << " " << y;
      }
      else if (x > 14.2) {
        EXPECT_FLOAT_EQ(h, -4.5) << x << " " << y;
      }
    });
  }
}

TYPED_TEST(RoughingCoverage, GapsAreCutNoDeeperThanTheirBridge)
{
  // A plate at -6 with a part of it not scanned; its cells say: bridged at -2.
  const Rectangle area{0, 0, 30, 24}, gap{8, 6, 22, 18};
  const auto cloud = surface(area, 0.25, [](double, double) { return -6.0; });
  auto map = mapOf(cloud, 0.5);
  CellCloud bridges;
  for (auto& c : *map)
    if (gap.holds(c.x, c.y)) {
      c.setState(CellState::Gap);
      c.count = 0;
      c.z = -2;
      bridges.push_back(c);
    }
  ASSERT_GT(bridges.size(), 500u);
  const auto stock = block(area, -6, 0);
  const Tool tool = Tool::flat(1, 5);
  this->set(tool, 0.3, 0.5, 2.0);
  this->roughing.setFloor(-5.5);
  this->roughing.setStock(stock);
  const auto index =
      std::make_shared<PointIndex>(makePointIndex(*cloud, pcl::Indices(1, 0), bridges));
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? index : nullptr);
    const auto field = simulate(this->run(map), tool, stock->stock(), 0.25);
    forCells(field, [&](double x, double y, double h) {
      if (gap.inner(0.5).holds(x, y)) {
        EXPECT_GE(h, -1.7 - 1e-4) << x << " " << y;
        EXPECT_LE(h, -1.0) << x << " " << y; // but its top is cut
      }
      else if (gap.distance(x, y) > 2.5) {
        EXPECT_FLOAT_EQ(h, -5.5) << x << " " << y;
      }
    });
  }
}

TYPED_TEST(RoughingCoverage, AHoleToBeMilledIsMilledThrough)
{
  const Rectangle area{0, 0, 30, 30}, hole{8, 8, 22, 22};
  const auto cloud = surface(area, 0.25, [&](double x, double y) {
    return hole.holds(x, y) ? std::nan("") : 0.0;
  });
  const auto stock = block(area, -4, 0);
  const Tool tool = Tool::flat(1, 5);
  for (const GapPolicy policy : {GapPolicy::Mill, GapPolicy::Bridge, GapPolicy::Keep}) {
    this->set(tool, 0.3, 1.0, 2.0);
    this->roughing.setFloor(-4);
    this->roughing.setStock(stock);
    const auto field =
        simulate(this->run(mapOf(cloud, 0.5, policy)), tool, stock->stock(), 0.25);
    forCells(field, [&](double x, double y, double h) {
      if (policy != GapPolicy::Mill || !hole.holds(x, y)) {
        EXPECT_EQ(h, 0) << x << " " << y;
      }
      else if (std::hypot(x - 15, y - 15) < 5) {
        EXPECT_FLOAT_EQ(h, -4) << x << " " << y;
      }
    });
  }
}
