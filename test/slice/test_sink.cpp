// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/sink.h>
#include <pointmill/slice/spacing.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <brute_force.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace pointmill;
using pointmill_test::Random;

namespace {

constexpr double kDegree = M_PI / 180;

/// The deepest that a tool gets below the plane z = rise * x with these points, at
/// random places in the middle of a square, along the normal.
double deepest(const Tool& tool,
               const std::vector<Eigen::Vector3f>& plan,
               double rise,
               double edge,
               int places)
{
  brute::Points points;
  for (const auto& p : plan)
    points.emplace_back(p.x(), p.y(), rise * p.x());
  // On the plane itself the tool stands this much over the place under its axis.
  double over = 0;
  for (double r = 0; r <= tool.radius(); r += tool.radius() / 1e5)
    over = std::max(over, rise * r - tool.profile(r));
  Random random(9);
  double deepest = 0;
  for (int i = 0; i < places; ++i) {
    const double x = random.uniform(0.4, 0.6) * edge;
    const double y = random.uniform(0.4, 0.6) * edge;
    const double tip = brute::drop(points, tool, x, y);
    deepest = std::max(deepest, rise * x + over - tip);
  }
  return deepest / std::hypot(1, rise);
}

const std::vector<Tool> kTools = {
    Tool::ball(1, 3), Tool::bull(2, 4, 0.5), Tool::bull(3, 4, 1.5), Tool::flat(4, 3)};

} // namespace

TEST(Sink, ClosedForms)
{
  const double s = 0.3, a = s / std::sqrt(2.0), r = 1.5;
  const Tool ball = Tool::ball(1, 2 * r), flat = Tool::flat(2, 6);
  EXPECT_NEAR(sinkBetweenPoints(ball, s), r - std::sqrt(r * r - s * s / 2), 1e-9);
  EXPECT_NEAR(sinkBetweenPoints(flat, s), 0, 1e-9);
  for (const double slope : {10.0, 30.0, 50.0}) {
    const double wide = a / std::cos(slope * kDegree);
    EXPECT_NEAR(
        sinkBetweenPoints(ball, s, slope), r - std::sqrt(r * r - wide * wide), 1e-8);
    EXPECT_NEAR(
        sinkBetweenPoints(flat, s, slope), 2 * a * std::sin(slope * kDegree), 1e-8);
  }
  // Bulging ground: 1 / R_eff = 1 / R + bulge, for voids much smaller than R.
  const double small = 0.01;
  EXPECT_NEAR(
      sinkBetweenPoints(ball, small, 0, 0.2) / (small * small / 4), 1 / r + 0.2, 1e-3);
  EXPECT_EQ(sinkBetweenPoints(ball, 3), INFINITY); // falls through
}

TEST(Sink, NoToolGetsDeeperOnAnyPoints)
{
  // Against brute force on square, random and strip-like points, with the voids that
  // mapSpacing() finds.
  const double edge = 12;
  Random random(5);
  std::vector<std::vector<Eigen::Vector3f>> plans(3);
  for (int i = 0; i < 48; ++i)
    for (int j = 0; j < 48; ++j)
      plans[0].emplace_back(0.25f * float(i), 0.25f * float(j), 0.f);
  for (int i = 0; i < 2500; ++i)
    plans[1].emplace_back(
        float(random.uniform(0, edge)), float(random.uniform(0, edge)), 0.f);
  for (int i = 0; i < 31; ++i)
    for (int j = 0; j < 240; ++j)
      plans[2].emplace_back(0.4f * float(i), 0.05f * float(j), 0.f);
  for (const auto& plan : plans) {
    const double worst = mapSpacing(plan).figures.worst;
    for (const Tool& tool : kTools)
      for (const double slope : {0.0, 20.0, 45.0, 65.0}) {
        const double bound = sinkBetweenPoints(tool, worst, slope);
        const double found = deepest(tool, plan, std::tan(slope * kDegree), edge, 300);
        EXPECT_LE(found, 1.0001 * bound + 1e-6) << tool.describe() << ' ' << slope;
      }
  }
}

TEST(Sink, IsReachedAcrossLines)
{
  // Lines along the contour lines of the slope leave voids that nothing narrows: the
  // bound is what happens.
  std::vector<Eigen::Vector3f> lines;
  for (int i = 0; i < 31; ++i)
    for (int j = 0; j < 1200; ++j)
      lines.emplace_back(0.4f * float(i), 0.01f * float(j), 0.f);
  for (const Tool& tool : kTools)
    for (const double slope : {0.0, 20.0, 45.0}) {
      const double bound = sinkBetweenPoints(tool, 0.4 / std::sqrt(2.0), slope);
      const double found = deepest(tool, lines, std::tan(slope * kDegree), 12, 300);
      EXPECT_GE(found, 0.95 * bound - 1e-6) << tool.describe() << ' ' << slope;
    }
}

TEST(Sink, TheMeanOnRandomPointsIsThatOfTheirDensity)
{
  // 1 / (2 pi rho R), 10.6 um for 10 points / mm2 under R 1.5.
  const double edge = 30, rho = 10;
  Random random(7);
  brute::Points points;
  for (int i = 0; i < int(edge * edge * rho); ++i)
    points.emplace_back(random.uniform(0, edge), random.uniform(0, edge), 0);
  double sum = 0;
  const int places = 4000;
  for (int i = 0; i < places; ++i)
    sum -= brute::drop(points,
                       Tool::ball(1, 3),
                       random.uniform(2, edge - 2),
                       random.uniform(2, edge - 2));
  const double mean = 1 / (2 * M_PI * rho * 1.5);
  EXPECT_NEAR(sum / places, mean, 0.06 * mean);
}

TEST(Sink, RefusesNonsense)
{
  const Tool ball = Tool::ball(1, 3);
  EXPECT_THROW(sinkBetweenPoints(ball, -1), ParameterError);
  EXPECT_THROW(sinkBetweenPoints(ball, NAN), ParameterError);
  EXPECT_THROW(sinkBetweenPoints(ball, 0.1, 90), ParameterError);
  EXPECT_THROW(sinkBetweenPoints(ball, 0.1, 0, -1), ParameterError);
}
