// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/rectangle.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pointmill::align;
using pointmill_test::Random;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

Polygon turned(const Polygon& points, double angle)
{
  Polygon result;
  for (const auto& p : points)
    result.emplace_back(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                        std::sin(angle) * p.x() + std::cos(angle) * p.y());
  return result;
}

// A filled rectangle with its corners, long side along X.
Polygon plate(double length, double width, Random& random)
{
  Polygon points = {{0, 0}, {length, 0}, {length, width}, {0, width}};
  for (int i = 0; i < 200; ++i)
    points.emplace_back(random.uniform(0, length), random.uniform(0, width));
  return points;
}

double squaring(const Polygon& points)
{
  return squaringAngle(convexHull(points));
}

} // namespace

TEST(Rectangle, HullOfManyPointsIsThatOfTheHullsOfSomeOfThem)
{
  Random random(17);
  const auto spot = [&](int shape) -> Eigen::Vector2d {
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
    const double angle = 3.14159265358979323846 * u;
    switch (shape) {
    case 0: // disc
      return std::sqrt(std::abs(v)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    case 1: // rectangle
      return {40 * u, 7 * v};
    case 2: // thin strip
      return {u, u + 1e-7 * v};
    case 3: // grid: many on one line
      return {std::floor(8 * u), std::floor(8 * v)};
    default: // one place
      return {3, 4};
    }
  };
  for (int shape = 0; shape <= 4; ++shape)
    for (const double turn : {0.0, 0.12, 0.79}) {
      Polygon points, corners;
      for (int i = 0; i < 5000; ++i)
        points.push_back(spot(shape));
      points = turned(points, turn);
      for (std::size_t i = 0; i < points.size(); i += 500) {
        const auto some = points.begin() + static_cast<std::ptrdiff_t>(i);
        for (const auto& p : convexHull(Polygon(some, some + 500)))
          corners.push_back(p);
      }
      ASSERT_LT(corners.size(), 1000u);
      EXPECT_EQ(convexHull(points), convexHull(corners)) << shape << " " << turn;
    }
}

TEST(Rectangle, HullIsConvexAndHoldsEveryPoint)
{
  Random random(1);
  Polygon points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(std::floor(random.uniform(0, 20)), // many collinear and equal
                        std::floor(random.uniform(0, 20)));
  const Polygon hull = convexHull(points);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d a = hull[i], b = hull[(i + 1) % hull.size()];
    const Eigen::Vector2d c = hull[(i + 2) % hull.size()];
    const auto left = [&](const Eigen::Vector2d& p) {
      return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
    };
    EXPECT_GT(left(c), 0);
    for (const auto& p : points)
      EXPECT_GE(left(p), 0);
  }
}

TEST(Rectangle, NoAngleIsBetterThanTheMinimum)
{
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    Polygon points;
    const int count = 3 + static_cast<int>(random.uniform() * 60);
    const double stretch = random.uniform(0.05, 1);
    for (int i = 0; i < count; ++i)
      points.emplace_back(10 * random.normal(), 10 * stretch * random.normal());
    const Polygon hull = convexHull(turned(points, random.uniform(0, 6)));
    const Rectangle found = minimumRectangle(hull);
    double best = 1e300;
    for (double a = 0; a < 90; a += 0.01) {
      const Rectangle box = boxAt(hull, a * degree);
      best = std::min(best, box.length * box.width);
    }
    EXPECT_LE(found.length * found.width, best * (1 + 1e-12)) << round;
    EXPECT_GT(found.length * found.width, best * 0.99) << round;
    EXPECT_GE(found.length, found.width);
  }
}

TEST(Rectangle, PointsAndLinesHaveNoWidth)
{
  EXPECT_EQ(minimumRectangle(convexHull({{3, 4}, {3, 4}})).length, 0);
  const Rectangle line = minimumRectangle(convexHull({{0, 0}, {1, 1}, {3, 3}}));
  EXPECT_NEAR(line.length, std::sqrt(18), 1e-12);
  EXPECT_EQ(line.width, 0);
  EXPECT_NEAR(line.angle, 45 * degree, 1e-12);
  EXPECT_NEAR(squaring({{0, 0}, {1, 1}, {3, 3}}), -45 * degree, 1e-12);
}

TEST(Rectangle, TheLongSideTurnsToXByTheSmallerAngle)
{
  Random random(3);
  const Polygon part = plate(100, 70, random);
  for (double a = -88; a <= 88; a += 11)
    EXPECT_NEAR(squaring(turned(part, a * degree)), -a * degree, 1e-9) << a;
  // About 90 degrees noise does not choose between the two.
  EXPECT_NEAR(squaring(turned(part, 89.7 * degree)), 90.3 * degree, 1e-9);
  EXPECT_NEAR(squaring(turned(part, 90 * degree)), 90 * degree, 1e-9);
  EXPECT_NEAR(squaring(turned(part, 90.3 * degree)), 89.7 * degree, 1e-9);
}

TEST(Rectangle, AnAlmostSquarePartDoesNotFlip)
{
  Random random(4);
  const Polygon square = plate(50.2, 50, random);
  EXPECT_EQ(squaring(square), 0);
  EXPECT_NEAR(squaring(turned(square, 90 * degree)), 0, 1e-12);
  EXPECT_NEAR(squaring(turned(square, 80 * degree)), 10 * degree, 1e-9);
  EXPECT_NEAR(squaring(turned(square, 30 * degree)), -30 * degree, 1e-9);
}

TEST(Rectangle, AnAlignedPartStaysWhereItIs)
{
  Random random(5);
  Polygon noisy; // its outline, measured
  for (int i = 0; i < 4000; ++i) {
    const double side = i % 2, s = random.uniform();
    const double error = 0.0005 * random.normal();
    if (i % 4 < 2)
      noisy.emplace_back(100 * s, 70 * side + error);
    else
      noisy.emplace_back(100 * side + error, 70 * s);
  }
  EXPECT_NE(minimumRectangle(convexHull(noisy)).angle, 0);
  EXPECT_EQ(squaring(noisy), 0);
}
