// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What single passes leave, against closed forms.
#include "verify_test.h"

using namespace verify_test;

namespace {

/// A block of 20 x 10 x 10 that one tool mills along Y = 5.
struct OneTool {
  ProgramVerifier verifier;

  explicit OneTool(const Tool& tool, double cell = 0.1)
  {
    const Cloud::Ptr bottom =
        surface({0, 0, 20, 10}, 1.0, [](double, double) { return -10; });
    verifier.setPart(indexOf(*bottom));
    verifier.setStock({{0, 0, -10}, {20, 10, 0}});
    verifier.setTools({tool});
    verifier.setCellSize(cell);
  }
  /// Compares the milled stock with `surface(x, y)`, which may reach above the block.
  template <typename Surface>
  void expect(const Text& text, Surface surface, double error)
  {
    const auto milled = verifier.verify(text.end()).milled;
    ASSERT_GT(milled.size(), 0u);
    for (const auto& cell : milled)
      ASSERT_NEAR(cell.z, std::min(0.0, surface(cell.x, cell.y)), error)
          << cell.x << " " << cell.y;
  }
};

Text along(double z0, double z1)
{
  return Text().over(-10, 5).feed(-10, 5, z0).feed(30, 5, z1);
}

} // namespace

TEST(ClosedForms, AFlatLeavesASlot)
{
  OneTool(Tool::flat(1, 4))
      .expect(
          along(-3, -3),
          [](double, double y) { return std::abs(y - 5) <= 2 ? -3.0 : 0.0; },
          1e-6);
}

TEST(ClosedForms, ABallLeavesACylinder)
{
  const double r = 3;
  OneTool(Tool::ball(1, 2 * r))
      .expect(
          along(-2, -2),
          [&](double, double y) {
            const double d = y - 5;
            return std::abs(d) > r ? 0 : -2 + r - std::sqrt(r * r - d * d);
          },
          1e-6);
}

TEST(ClosedForms, ABallOnASlantLeavesASlantedCylinder)
{
  const double r = 3, slope = -0.1; // Z falls by 4 over 40
  OneTool(Tool::ball(1, 2 * r))
      .expect(
          along(-1, -5),
          [&](double x, double y) {
            const double d = y - 5, centre = -1 + slope * (x + 10) + r;
            return std::abs(d) > r ? 0
                                   : centre - std::sqrt(1 + slope * slope) *
                                                  std::sqrt(r * r - d * d);
          },
          2e-6);
}

TEST(ClosedForms, ABullNoseLeavesAFlatWithRoundCorners)
{
  const double flat = 2, corner = 1;
  OneTool(Tool::bull(1, 6, corner))
      .expect(
          along(-2, -2),
          [&](double, double y) {
            const double u = std::abs(y - 5) - flat;
            return u > corner ? 0.0
                   : u > 0    ? -2 + corner - std::sqrt(corner * corner - u * u)
                              : -2.0;
          },
          1e-6);
}

TEST(ClosedForms, ATaperedBallLeavesAGrooveWithSlantedFlanks)
{
  const double r = 0.5, t = 10 * M_PI / 180;
  OneTool(Tool::taperBall(1, 2 * r, 10, 8), 0.05)
      .expect(
          along(-3, -3),
          [&](double, double y) {
            const double d = std::abs(y - 5);
            return d <= r * std::cos(t) ? -3 + r - std::sqrt(r * r - d * d)
                                        : -3 + r + (d - r / std::cos(t)) / std::tan(t);
          },
          1e-5);
}

TEST(ClosedForms, AnArcLeavesARingToTheErrorOfItsChords)
{
  // A full circle of radius 3 with a ball of radius 1: a torus. The reader's chords lie
  // up to 1e-4 inside the arc, which is 1e-4 of a height where the flank has 45
  // degrees, and less than a hundredth of a millimetre 0.1 mm from the groove's rim.
  Text text;
  text.over(13, 5).feed(13, 5, -0.6);
  text("G2 X13. Y5. I-3. J0. F600");
  OneTool job(Tool::ball(1, 2));
  const auto milled = job.verifier.verify(text.end()).milled;
  double worst = 0;
  for (const auto& cell : milled) {
    const double d = std::hypot(cell.x - 10, cell.y - 5) - 3;
    if (std::abs(d) > 0.7)
      continue;
    const double truth = std::min(0.0, -0.6 + 1 - std::sqrt(1 - d * d));
    worst = std::max(worst, std::abs(cell.z - truth));
  }
  EXPECT_LE(worst, 1.1e-4);
  EXPECT_GT(worst, 1e-6); // chords they are
}

TEST(ClosedForms, TwoBallPassesLeaveTheScallopOfTheory)
{
  const double r = 3, step = 0.5, cell = 0.1;
  Text text;
  for (double y = 1; y <= 9; y += step)
    text.over(-10, y).feed(-10, y, -2).feed(30, y, -2);
  OneTool job(Tool::ball(1, 2 * r), cell);
  const auto milled = job.verifier.verify(text.end()).milled;
  double highest = -10;
  for (const auto& c : milled)
    if (c.y > 1 && c.y < 9)
      highest = std::max<double>(highest, c.z);
  // The crest lies on a cell's centre: rows at 1, 1.5, ... and centres at 0.05, 0.15.
  EXPECT_NEAR(highest + 2, r - std::sqrt(r * r - step * step / 4), 1e-6);
}

TEST(ClosedForms, ARidgeOfPassesAlongItIsMeasuredAsItIs)
{
  // Half a cylinder of radius 20, finished along its axis by a ball of radius 3 at
  // equal angles: what stands over each point follows from circles alone.
  const double big = 20, r = 3, angle = 0.025;
  const double crest = (big + r) * std::cos(angle / 2) -
                       std::sqrt(r * r - std::pow((big + r) * std::sin(angle / 2), 2)) -
                       big;
  EXPECT_NEAR(crest, 0.012, 2e-5);
  const auto part = surface({0, -8, 10, 8}, 0.05, [&](double x, double y) {
    return std::fmod(x, 1) < 0.06 ? std::sqrt(big * big - y * y) - big : std::nan("");
  });
  const auto centre = [&](int k) {
    return Eigen::Vector2d((big + r) * std::sin(k * angle),
                           (big + r) * std::cos(k * angle) - big);
  };
  Text text;
  const int most = 24;
  for (int k = -most; k <= most; ++k)
    text.over(-5, centre(k).x())
        .feed(-5, centre(k).x(), centre(k).y() - r)
        .feed(15, centre(k).x(), centre(k).y() - r);
  ProgramVerifier verifier;
  verifier.setPart(indexOf(*part));
  verifier.setStock({{0, -10, -10}, {10, 10, 0.5}});
  verifier.setTools({Tool::ball(1, 2 * r)});
  verifier.setTolerance(0.001);
  const auto result = verifier.verify(text.end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_LE(result.gouge, 2e-6); // rounding of the points and of the text
  ASSERT_EQ(result.deviations.size(), part->size());
  double highest = 0;
  for (const auto& p : result.deviations) {
    double left = 1e9;
    for (int k = -most; k <= most; ++k) {
      const double d = p.y - centre(k).x();
      if (std::abs(d) <= r)
        left = std::min(left, centre(k).y() - std::sqrt(r * r - d * d));
    }
    ASSERT_NEAR(p.intensity, left - p.z, 5e-6) << p.y;
    if (std::abs(p.y) < 2)
      highest = std::max<double>(highest, p.intensity);
  }
  // The points are 0.05 apart, the crests sharp, and what is measured is upright.
  EXPECT_GE(highest, 0.9 * crest);
  EXPECT_LE(highest, 1.01 * crest);
  EXPECT_NEAR(result.deviation.max, result.residual.max, 1e-3);
}

TEST(Deviations, AreOfTheMeasuredPointsAndNanWhereNoToolPasses)
{
  const auto plate = surface({0, 0, 20, 10}, 0.5, [](double, double) { return -2; });
  const auto smooth = surface({0, 0, 20, 10}, 0.5, [](double, double) { return -2.1; });
  ProgramVerifier verifier;
  verifier.setPart(indexOf(*plate));
  verifier.setModel(indexOf(*smooth));
  verifier.setStock({{0, 0, -3}, {20, 10, 0}});
  verifier.setTools({Tool::flat(1, 4)});
  verifier.setNoiseAllowance(0.2);
  const auto result =
      verifier.verify(Text().over(-5, 3).feed(-5, 3, -2.05).feed(25, 3, -2.05).end());
  ASSERT_EQ(result.deviations.size(), plate->size());
  std::size_t untouched = 0;
  for (const auto& p : result.deviations) {
    EXPECT_EQ(p.z, -2);
    const bool passed = std::abs(p.y - 3) <= 2;
    ASSERT_EQ(std::isnan(p.intensity), !passed) << p.y;
    untouched += !passed;
    if (passed) {
      ASSERT_NEAR(p.intensity, -0.05, 1e-6);
    }
  }
  EXPECT_EQ(result.untouched_points, untouched);
  EXPECT_NEAR(
      result.untouchedShare(), double(untouched) / double(plate->size()), 1e-12);
}
