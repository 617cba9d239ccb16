// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What is cut, against closed forms.
#include <pointmill/link/cut_meter.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pointmill;
using Eigen::Vector3d;

namespace {

const Stock kBlock{{0, 0, -10}, {60, 40, 0}};
constexpr double kCell = 0.1;

StockField block()
{
  return {kBlock, kCell, StockField::Bound::Nominal};
}

/// A straight cut all through the block, its middle line through (x, y).
struct Line {
  Vector3d from, to;
  Line(double x, double y, double z, double degrees)
  {
    const double a = degrees * M_PI / 180;
    const Vector3d half(60 * std::cos(a), 60 * std::sin(a), 0);
    from = Vector3d(x, y, z) - half;
    to = Vector3d(x, y, z) + half;
  }
  Vector3d left(double by) const
  {
    const Vector3d d = (to - from).normalized();
    return {-d.y() * by, d.x() * by, 0};
  }
};

/// What the cells may add to, or take from, the width of a cut: as a piece of a quarter
/// of the diameter counts whole cells, those of its flanks may all be on one side.
double bound(double diameter)
{
  return kCell * (2 + 4 * kCell / diameter);
}

/// Width at which a tool's profile takes more than swarf off a face `depth` above it.
double chord(const Tool& tool, double depth)
{
  const double r = tool.corner_radius, d = depth - Cut::kSwarf;
  return 2 * (tool.flatRadius() + std::sqrt(r * r - (r - d) * (r - d)));
}

} // namespace

TEST(CutMeter, ASlotIsAsWideAsTheTool)
{
  for (const double degrees : {0.0, 90.0, 30.0, 57.0}) {
    auto stock = block();
    CutMeter meter(Tool::flat(1, 6), stock);
    const Line line(30.03, 20.04, -2, degrees);
    const double section = meter.cut(line.from, line.to, Motion::Cut);
    EXPECT_LE(meter.figures().max_radial, 6.0);
    EXPECT_GE(meter.figures().max_radial, 6.0 - bound(6)) << degrees;
    EXPECT_NEAR(meter.figures().max_axial, 2, 1e-6);
    EXPECT_NEAR(section, 12, 2 * bound(6)) << degrees;
  }
}

TEST(CutMeter, ASideCutIsAsWideAsItsStepOver)
{
  for (const Tool& tool : {Tool::flat(1, 6), Tool::flat(2, 10)})
    for (const double degrees : {0.0, 90.0, 30.0, 113.0})
      for (const double width : {0.6, 1.5, 3.0}) {
        auto stock = block();
        CutMeter first(tool, stock), meter(tool, stock);
        const Line line(30.03, 20.04, -2, degrees);
        first.cut(line.from, line.to, Motion::Cut);
        const Vector3d aside = line.left(width);
        meter.cut(line.from + aside, line.to + aside, Motion::Cut);
        const auto& f = meter.figures();
        EXPECT_NEAR(f.max_radial, width, bound(tool.diameter))
            << tool.diameter << " at " << degrees;
        EXPECT_LE(f.mean_radial, f.max_radial);
        // Less at the block's corners only.
        EXPECT_NEAR(f.mean_radial, width, 0.25 * width + 0.05) << degrees;
        EXPECT_NEAR(f.max_axial, 2, 1e-6);
      }
}

TEST(CutMeter, ARoundEndIsAsWideAsItIsDeep)
{
  for (const Tool& tool : {Tool::ball(1, 8), Tool::bull(2, 8, 2)})
    for (const double degrees : {0.0, 90.0, 40.0}) {
      auto stock = block();
      CutMeter meter(tool, stock);
      const Line line(30.03, 20.04, -1, degrees);
      meter.cut(line.from, line.to, Motion::Cut);
      EXPECT_NEAR(meter.figures().max_radial, chord(tool, 1), bound(8)) << degrees;
      EXPECT_NEAR(meter.figures().max_axial, 1, 0.01);
    }
}

TEST(CutMeter, LengthsAndVolumeAddUp)
{
  auto stock = block();
  CutMeter meter(Tool::flat(1, 6), stock);
  meter.cut({-20, 20, -2}, {80, 20, -2}, Motion::Cut);
  const auto& f = meter.figures();
  EXPECT_NEAR(f.volume, 60 * 6 * 2, 60 * 2 * kCell);
  EXPECT_NEAR(f.material_length + f.air_length, 100, 1e-9);
  EXPECT_NEAR(f.material_length, 64.5, 1.6); // 3 mm before, a piece or so each end
  EXPECT_NEAR(f.airShare(), 1 - f.material_length / 100, 1e-12);
  const double before = f.volume;
  meter.cut({80, 20, -2}, {-20, 20, -2}, Motion::Cut); // all is gone
  EXPECT_EQ(meter.figures().volume, before);
  EXPECT_NEAR(meter.figures().air_length, 100 + 35.5, 1.6);
}

TEST(CutMeter, ManySmallMovesAreEngagedAsOneIs)
{
  auto whole = block(), parts = whole;
  CutMeter one(Tool::flat(1, 6), whole), many(Tool::flat(1, 6), parts);
  const Vector3d a(-5, 20.04, -2), b(65, 20.04, -2);
  one.cut(a, b, Motion::Cut);
  Vector3d at = a;
  for (int i = 1; i <= 2000; ++i) {
    const Vector3d next = a + (b - a) * (i / 2000.0);
    EXPECT_LE(many.cut(at, next, Motion::Cut), 12 + 2 * bound(6)) << i;
    at = next;
  }
  EXPECT_NEAR(many.figures().max_radial, one.figures().max_radial, bound(6));
  EXPECT_NEAR(many.figures().volume, one.figures().volume, 1e-3);
}

TEST(CutMeter, ASteepDescentTakesWhatIsEngagedAtOnce)
{
  auto stock = block();
  CutMeter meter(Tool::ball(1, 8), stock);
  meter.cut({30, 20, 1}, {30, 20, -9}, Motion::Plunge);
  EXPECT_LE(meter.figures().max_axial, 8.0 / 4 + 1e-6);
  EXPECT_GE(meter.figures().max_axial, 8.0 / 4 - 0.5);
  EXPECT_EQ(meter.figures().max_radial, 0) << "a plunge is no slot";
  EXPECT_NEAR(meter.figures().volume,
              M_PI * 16 * 5 + 2.0 / 3 * M_PI * 64, // a cylinder and half a ball
              4);
}

TEST(CutMeter, RampsAreNoSlots)
{
  auto stock = block();
  CutMeter meter(Tool::flat(1, 6), stock);
  meter.cut({20, 20, 0}, {40, 20, -1}, Motion::Ramp);
  EXPECT_EQ(meter.figures().max_radial, 0);
  meter.cut({40, 20, -1}, {20, 20, -1}, Motion::Cut);
  EXPECT_GT(meter.figures().max_radial, 5); // the wedge that the ramp left
}

TEST(CutMeter, OfAPathIsThatOfItsFeedMoves)
{
  CLCloud path;
  for (const auto& p : {PointCL(-10, 20, 5, Motion::Rapid),
                        PointCL(-10, 20, -2, Motion::Rapid),
                        PointCL(70, 20, -2, Motion::Cut),
                        PointCL(70, 20, 5, Motion::Retract)})
    path.push_back(p);
  auto stock = block();
  const auto figures = measureCut(path, Tool::flat(1, 6), stock);
  EXPECT_NEAR(figures.volume, 720, 13);
  EXPECT_NEAR(figures.material_length + figures.air_length, 80, 1e-6);
}
