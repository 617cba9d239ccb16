// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/maximum.h>
#include <pointmill/surface/sweep.h>

#include <brute_force.h>
#include <gtest/gtest.h>

#include <random>

using Eigen::Vector3d;
using pointmill::maximumOf;
using pointmill::Tool;

namespace {
const std::vector<Tool> kTools{
    Tool::flat(1, 4.0), Tool::ball(2, 3.0), Tool::bull(3, 5.0, 1.0)};
}

TEST(Sweep, ABallAlongALineLeavesACylinder)
{
  const Tool ball = Tool::ball(1, 6.0);
  const Vector3d a(0, 0, 1), b(10, 0, 1);
  for (double y = 0; y < 3; y += 0.3)
    EXPECT_NEAR(
        pointmill::sweptHeight(ball, a, b, 5, y), 4 - std::sqrt(9 - y * y), 1e-12);
  EXPECT_TRUE(std::isinf(pointmill::sweptHeight(ball, a, b, 5, 3.01)));
}

TEST(Sweep, ABallDownASlopeLeavesATiltedCylinder)
{
  // At 45 degrees the swept cylinder's lowest line lies R (sqrt 2 - 1) above the tips'.
  const Tool ball = Tool::ball(1, 2.0);
  const double h =
      pointmill::sweptHeight(ball, Vector3d(0, 0, 0), Vector3d(20, 0, 20), 10, 0);
  EXPECT_NEAR(h, 10 + 1 - std::sqrt(2.0), 1e-12);
}

TEST(Sweep, HeightAgreesWithManySmallSteps)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-4, 4);
  for (const auto& tool : kTools)
    for (int i = 0; i < 60; ++i) {
      const Vector3d a(u(random), u(random), u(random));
      Vector3d b(u(random), u(random), i % 3 ? u(random) : a.z());
      if (i % 7 == 0)
        b.head<2>() = a.head<2>(); // a plunge
      const double x = u(random), y = u(random);
      const double fast = pointmill::sweptHeight(tool, a, b, x, y);
      const double slow = brute::swept(tool, a, b, x, y);
      if (std::isinf(slow))
        continue; // sampled steps may miss a graze
      EXPECT_LE(fast, slow + 1e-9) << tool.describe() << " " << i;
      EXPECT_NEAR(fast, slow, 0.03) << tool.describe() << " " << i;
    }
}

TEST(Sweep, ASlantedMoveIsLowestWhereASearchAlongItSays)
{
  // Short and long, gentle and steep, up and down: the lowest place may be either end
  // of what passes over, or between them on the tip, the rounding, the cone or the
  // shoulder.
  const Tool tools[] = {Tool::bull(1, 6, 1),
                        Tool::bull(2, 6, 2.9),
                        Tool::ball(3, 6),
                        Tool::flat(4, 6),
                        Tool::taperBall(5, 1, 5, 6),
                        Tool::taperBall(6, 2, 30, 8)};
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(-1, 1);
  int inside = 0, at_end = 0;
  for (const auto& tool : tools) {
    const auto cutter = tool.profile();
    const double r = tool.radius();
    for (int i = 0; i < 2000; ++i) {
      const double length = i % 2 ? 0.1 : 8.0, turn = 3 * u(random);
      const double slope = std::pow(10, 2 * u(random)) * (i % 3 ? 1 : -1);
      const Vector3d a(u(random), u(random), u(random));
      const Vector3d along(std::cos(turn), std::sin(turn), slope);
      const Vector3d b = a + length * along;
      const Eigen::Vector2d p(r * u(random), r * u(random));
      const double middle = (p - a.head<2>()).dot(along.head<2>());
      const double off2 = (p - a.head<2>()).squaredNorm() - middle * middle;
      const double half = std::sqrt(std::max(0.0, r * r - off2));
      const double first = std::max(0.0, middle - half),
                   last = std::min(length, middle + half);
      if (half < 1e-3 || last - first < 1e-3)
        continue;
      const auto heightAt = [&](double s) {
        const double d2 = std::max(0.0, off2 + (s - middle) * (s - middle));
        return a.z() + s * slope + cutter.height(std::min(r, std::sqrt(d2)));
      };
      const double lowest =
          -maximumOf(first, last, [&](double s) { return -heightAt(s); });
      EXPECT_NEAR(pointmill::sweptHeight(tool, a, b, p.x(), p.y()), lowest, 1e-9)
          << tool.describe() << " " << i;
      ++(lowest < std::min(heightAt(first), heightAt(last)) - 1e-9 ? inside : at_end);
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(at_end, 1000);
}

TEST(Sweep, PenetrationAgreesWithManySmallSteps)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> u(-3, 3);
  int hits = 0;
  for (const auto& tool : kTools)
    for (int i = 0; i < 150; ++i) {
      const Vector3d a(u(random), u(random), u(random));
      Vector3d b(u(random), u(random), i % 3 ? u(random) : a.z());
      if (i % 7 == 0)
        b.head<2>() = a.head<2>();
      const Vector3d p(u(random), u(random), u(random));
      const double fast = std::max(0.0, pointmill::penetration(tool, a, b, p));
      const double slow = brute::gouge(tool, a, b, p);
      hits += slow > 0.01;
      EXPECT_NEAR(fast, slow, 0.005) << tool.describe() << " " << i;
    }
  EXPECT_GT(hits, 100);
}

TEST(Sweep, BesideAWallPenetrationIsTheOverlapNotTheHeight)
{
  // The tool passes 0.02 mm too near to a point high up on a wall.
  for (const auto& tool : kTools) {
    const double y = tool.radius() - 0.02;
    EXPECT_NEAR(pointmill::penetration(
                    tool, Vector3d(-5, 0, 0), Vector3d(5, 0, 0), Vector3d(0, y, 30)),
                0.02,
                1e-9);
  }
}
