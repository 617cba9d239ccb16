// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/surface/stock_field.h>
#include <pointmill/surface/sweep.h>

#include <brute_force.h>
#include <gtest/gtest.h>

#include <random>

using Eigen::Vector3d;
using pointmill::Cut;
using pointmill::Stock;
using pointmill::StockField;
using pointmill::Tool;

namespace {
const Stock kBox{{0, 0, -10}, {20, 10, 0}};
}

TEST(StockField, AFlatLeavesASlot)
{
  StockField field(kBox, 0.1, StockField::Bound::Nominal);
  const double deepest =
      field.cut(Tool::flat(1, 4), Vector3d(-5, 5, -1), Vector3d(25, 5, -1)).depth;
  EXPECT_NEAR(deepest, 1.0, 1e-6);
  for (int row = 0; row < field.rows(); ++row)
    EXPECT_NEAR(field.height(100, row), std::abs(field.y(row) - 5) <= 2 ? -1 : 0, 1e-6);
}

TEST(StockField, TwoBallPassesLeaveTheScallopOfTheory)
{
  // Scallop between two passes: R - sqrt(R^2 - s^2 / 4).
  StockField field(kBox, 0.02, StockField::Bound::Nominal);
  const Tool ball = Tool::ball(1, 3);
  const double s = 0.6;
  for (double y : {5 - s / 2, 5 + s / 2})
    field.cut(ball, Vector3d(-5, y, -1), Vector3d(25, y, -1));
  const int row = field.rowOf(5.0); // its centre is half a cell off the middle
  const double away = s / 2 - std::abs(field.y(row) - 5.0);
  EXPECT_NEAR(away, 0.29, 1e-9);
  EXPECT_NEAR(
      field.height(500, row), -1 + 1.5 - std::sqrt(1.5 * 1.5 - away * away), 1e-6);
}

TEST(StockField, TheUpperBoundIsOne)
{
  StockField upper(kBox, 0.5, StockField::Bound::Upper);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> ux(-2, 22), uy(-2, 12), uz(-6, 1);
  std::vector<std::pair<Vector3d, Vector3d>> moves;
  const Tool tools[] = {Tool::flat(1, 5), Tool::ball(2, 4)};
  for (int i = 0; i < 12; ++i) {
    moves.emplace_back(Vector3d(ux(random), uy(random), uz(random)),
                       Vector3d(ux(random), uy(random), uz(random)));
    upper.cut(tools[i % 2], moves.back().first, moves.back().second);
  }
  for (int i = 0; i < 3000; ++i) {
    const double x = ux(random), y = uy(random);
    if (x < 0 || x >= 20 || y < 0 || y >= 10)
      continue;
    double truth = 0;
    for (std::size_t k = 0; k < moves.size(); ++k)
      truth = std::min(
          truth,
          brute::swept(tools[k % 2], moves[k].first, moves[k].second, x, y, 200));
    EXPECT_GE(upper.height(int(x / 0.5), int(y / 0.5)), truth - 0.2) << x << " " << y;
    EXPECT_GE(upper.highest(x, y, 0.0), truth - 0.2);
  }
  double lowest = 0;
  for (int row = 0; row < upper.rows(); ++row)
    for (int column = 0; column < upper.columns(); ++column)
      lowest = std::min(lowest, upper.height(column, row));
  EXPECT_LT(lowest, -1.0); // and it did cut
}

TEST(StockField, ReportsTheVolumeTaken)
{
  StockField field(kBox, 0.05, StockField::Bound::Nominal);
  const Cut slot =
      field.cut(Tool::flat(1, 4), Vector3d(-5, 5, -2), Vector3d(25, 5, -2));
  EXPECT_NEAR(slot.volume, 20 * 4 * 2, 2);
  EXPECT_EQ(
      field.cut(Tool::flat(1, 4), Vector3d(-5, 5, -2), Vector3d(25, 5, -2)).volume, 0);
}

TEST(StockField, HighestSeesAllWithinReach)
{
  StockField field(kBox, 0.5, StockField::Bound::Upper);
  field.cut(Tool::flat(1, 30), Vector3d(-5, 5, -3), Vector3d(10, 5, -3));
  EXPECT_EQ(field.highest(-50, 5, 2), -INFINITY);
  EXPECT_EQ(field.highest(0, 5, 2), -3.0);
  EXPECT_EQ(field.highest(25, 5, 2), -INFINITY);
  StockField fresh(kBox, 0.5, StockField::Bound::Upper);
  EXPECT_EQ(fresh.highest(-5, 5, 30, 5, 1), 0.0);
}

TEST(StockField, NoCellThatAMoveLowersIsPassedOver)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> ux(-4, 24), uy(-4, 14), uz(-8, 1), u(0, 1);
  const Tool tools[] = {
      Tool::flat(1, 5), Tool::ball(2, 3), Tool::bull(3, 4, 0.7), Tool::ball(4, 0.8)};
  StockField field(kBox, 0.23, StockField::Bound::Nominal);
  const int columns = field.columns();
  std::vector<float> truth(static_cast<std::size_t>(columns) * field.rows(), 0.f);
  Vector3d at(0, 0, 1);
  for (int i = 0; i < 400; ++i) {
    Vector3d to(ux(random), uy(random), uz(random) * (1 - i / 500.0));
    if (i % 3)
      to = at + 0.05 * (to - at);
    if (i % 13 == 0)
      to = at - Vector3d(0, 0, u(random));
    const Tool& tool = tools[i % 4];
    double depth = 0, volume = 0;
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < columns; ++column) {
        float& cell = truth[static_cast<std::size_t>(row * columns + column)];
        const double h =
            pointmill::sweptHeight(tool, at, to, field.x(column), field.y(row));
        if (!(h < cell))
          continue;
        depth = std::max(depth, cell - h);
        volume += (cell - h) * 0.23 * 0.23;
        cell = static_cast<float>(h);
      }
    const Cut cut = field.cut(tool, at, to);
    ASSERT_EQ(cut.depth, depth) << i;
    ASSERT_EQ(cut.volume, volume) << i;
    at = to;
  }
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 0; column < columns; ++column)
      ASSERT_EQ(field.height(column, row),
                truth[static_cast<std::size_t>(row * columns + column)]);
  for (int i = 0; i < 1000; ++i) {
    const double x = ux(random), y = uy(random), radius = 3 * u(random);
    const double reach = radius + 0.23 * std::sqrt(0.5);
    double highest = -INFINITY;
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < columns; ++column)
        if (std::hypot(field.x(column) - x, field.y(row) - y) <= reach)
          highest = std::max(highest, field.height(column, row));
    ASSERT_EQ(field.highest(x, y, radius), highest);
  }
}

TEST(StockField, QuickCutsAreCuts)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<double> ux(-4, 24), uy(-4, 14), uz(-8, 1), u(0, 1);
  const Tool tools[] = {Tool::flat(1, 5),
                        Tool::ball(2, 3),
                        Tool::bull(3, 4, 0.7),
                        Tool::taperBall(4, 1, 8, 5),
                        Tool::cone(5, 40, 6, 0.2)};
  std::vector<pointmill::SweptCutter> cutters(std::begin(tools), std::end(tools));
  StockField slow(kBox, 0.17, StockField::Bound::Nominal), quick = slow;
  Vector3d at(0, 0, 1);
  for (int i = 0; i < 500; ++i) {
    Vector3d to(ux(random), uy(random), uz(random) * (1 - i / 600.0));
    if (i % 3)
      to = at + 0.05 * (to - at);
    if (i % 13 == 0)
      to = at - Vector3d(0, 0, u(random));
    const int row0 = i % 7 ? 0 : 11, row1 = i % 5 ? slow.rows() : 40;
    std::vector<pointmill::LoweredCell> one, two;
    EXPECT_GE(quick.depthAlong(cutters[i % 5], at, to, row0, row1), 0);
    const double before = quick.depthAlong(cutters[i % 5], at, to, row0, row1);
    const Cut a = slow.cut(tools[i % 5], at, to, row0, row1, &one);
    const Cut b = quick.cut(cutters[i % 5], at, to, row0, row1, &two);
    ASSERT_EQ(a.depth, b.depth) << i;
    ASSERT_EQ(a.depth, before) << i;
    ASSERT_NEAR(a.volume, b.volume, 1e-12 * (1 + a.volume)) << i;
    ASSERT_EQ(one.size(), two.size()) << i;
    for (std::size_t k = 0; k < one.size(); ++k) {
      ASSERT_EQ(one[k].column, two[k].column);
      ASSERT_EQ(one[k].depth, two[k].depth);
    }
    at = to;
  }
  double highest = -10;
  for (int row = 5; row < 9; ++row)
    for (int column = 0; column < slow.columns(); ++column) {
      ASSERT_EQ(slow.height(column, row), quick.height(column, row));
      highest = std::max(highest, quick.height(column, row));
    }
  EXPECT_EQ(quick.highestIn(5, 9), highest);
}

TEST(SweptCutter, ItsFloorIsALowerBoundThatIsClose)
{
  std::mt19937 random(14);
  std::uniform_real_distribution<double> u(0, 1);
  for (const Tool& tool : {Tool::flat(1, 5),
                           Tool::ball(2, 3),
                           Tool::ball(2, 0.05),
                           Tool::bull(3, 40, 0.7),
                           Tool::taperBall(4, 1, 8, 5),
                           Tool::cone(5, 40, 6, 0.2)}) {
    const pointmill::SweptCutter cutter(tool);
    const double r = tool.radius();
    for (int i = 0; i < 5000; ++i) {
      const double at = 1.1 * r * u(random);
      ASSERT_LE(cutter.floor(at * at), tool.profile(at)) << tool.describe() << at;
      if (at < 0.99 * r) {
        ASSERT_GE(cutter.floor(at * at), tool.profile(0.998 * at) - 0.05 * r);
      }
    }
    EXPECT_LE(cutter.floor(r * r), tool.profile(r));
    EXPECT_EQ(cutter.floor(r * r * 1.001), INFINITY);
    for (int i = 0; i < 5000; ++i) {
      const Vector3d a(u(random), u(random), u(random)),
          b = a + Vector3d(u(random) - 0.5, u(random) - 0.5, u(random) - 0.5);
      const double x = 2 * u(random) - 0.5, y = 2 * u(random) - 0.5;
      ASSERT_LE(cutter.floor(a, b, x, y), pointmill::sweptHeight(tool, a, b, x, y));
    }
  }
}

TEST(StockField, AProbeTakesWhatTheMovesWould)
{
  std::mt19937 random(12);
  std::uniform_real_distribution<double> ux(-4, 24), uy(-4, 14), uz(-8, 1);
  const Tool tools[] = {Tool::flat(1, 5), Tool::ball(2, 3), Tool::bull(3, 4, 0.7)};
  StockField field(kBox, 0.23, StockField::Bound::Nominal);
  for (int i = 0; i < 60; ++i) {
    const Tool& tool = tools[i % 3];
    std::vector<Vector3d> way;
    for (int k = 0; k < 2 + i % 4; ++k)
      way.emplace_back(ux(random), uy(random), uz(random) * (1 - i / 100.0));
    const Cut probed = field.probe(tool, way);
    StockField cut = field;
    double volume = 0;
    for (std::size_t k = 1; k < way.size(); ++k)
      volume += cut.cut(tool, way[k - 1], way[k]).volume;
    EXPECT_NEAR(probed.volume, volume, 1e-4 * (1 + volume));
    double deepest = 0;
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < field.columns(); ++column)
        deepest = std::max(deepest,
                           double(field.height(column, row)) - cut.height(column, row));
    EXPECT_NEAR(probed.depth, deepest, 1e-5);
    if (i % 5 == 0)
      field = cut;
  }
}

TEST(StockField, GroundThatIsBegunCountsOnce)
{
  // In one move or in many, the area over the way is the width of the cut.
  for (const Tool& tool : {Tool::flat(1, 4), Tool::ball(2, 4)})
    for (const int moves : {1, 7, 400}) {
      StockField field(kBox, 0.05, StockField::Bound::Nominal);
      const Vector3d a(-5, 5.01, -1), b(25, 5.01, -1);
      double area = 0, axial = 0;
      for (int i = 0; i < moves; ++i) {
        const Cut taken = field.cut(
            tool, a + (b - a) * (double(i) / moves), a + (b - a) * ((i + 1.0) / moves));
        area += taken.area;
        axial = std::max(axial, taken.axial);
      }
      const double deep = 1 - Cut::kSwarf;
      const double wide = tool.isFlat() ? 4 : 2 * std::sqrt(4 * deep - deep * deep);
      EXPECT_NEAR(area, 20 * wide, 20 * 0.1) << tool.type() << moves;
      EXPECT_NEAR(axial, 1, 1e-3);
    }
}

TEST(StockField, RowsCanBeSharedOut)
{
  StockField whole(kBox, 0.5, StockField::Bound::Nominal), parts = whole;
  const Tool ball = Tool::ball(1, 6);
  const Vector3d a(1, 1, -2), b(18, 9, -4);
  whole.cut(ball, a, b);
  for (int row = 0; row < parts.rows(); row += 3)
    parts.cut(ball, a, b, row, std::min(row + 3, parts.rows()));
  for (int row = 0; row < parts.rows(); ++row)
    for (int column = 0; column < parts.columns(); ++column)
      ASSERT_EQ(parts.height(column, row), whole.height(column, row));
}

TEST(StockField, RefusesABoxWithoutVolume)
{
  EXPECT_THROW(StockField({{0, 0, 0}, {1, 1, 0}}, 0.5, StockField::Bound::Upper),
               pointmill::ParameterError);
  EXPECT_THROW(StockField(kBox, 0.0, StockField::Bound::Upper),
               pointmill::ParameterError);
}
