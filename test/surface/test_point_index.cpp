// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/sweep.h>

#include <brute_force.h>
#include <gtest/gtest.h>

#include <random>

using Eigen::Vector3d;
using pointmill::PointIndex;
using pointmill::Tool;

namespace {

/// Points on z = f(x, y) over a square grid, and the index of them.
struct Sampled {
  brute::Points points;
  std::vector<float> x, y, z;
  template <typename F>
  Sampled(double x0, double x1, double step, F f)
  {
    for (double v = x0; v <= x1 + 1e-9; v += step)
      for (double u = x0; u <= x1 + 1e-9; u += step)
        add(u, v, f(u, v));
  }
  void add(double u, double v, double w)
  {
    x.push_back(float(u)), y.push_back(float(v)), z.push_back(float(w));
    points.emplace_back(x.back(), y.back(), z.back());
  }
  PointIndex index() const { return {x, y, z}; }
};

const std::vector<Tool> kTools{
    Tool::flat(1, 4.0), Tool::ball(2, 3.0), Tool::bull(3, 5.0, 1.0)};

double rough(double x, double y)
{
  return 2 * std::sin(x) * std::cos(0.7 * y) + (x > 2 ? 3 : 0);
}

} // namespace

TEST(PointIndex, EveryToolRestsOnAPlane)
{
  // A point right under the axis: the tip touches it, whatever the cutter.
  const Sampled plane(-10, 10, 0.5, [](double, double) { return 1.25; });
  for (const auto& tool : kTools)
    EXPECT_NEAR(plane.index().drop(tool, 0, 0).tip, 1.25, 1e-7) << tool.describe();
}

TEST(PointIndex, ABallOnAHemisphereIsTheOffsetSphere)
{
  // Contact points lie on the sphere of radius 30, ball centres on that of 30 + R.
  const double R = 30, r = 1.5, step = 0.05;
  const Sampled dome(-8, 8, step, [&](double x, double y) {
    return std::sqrt(R * R - x * x - y * y);
  });
  const PointIndex index = dome.index();
  const double sink = r - std::sqrt(r * r - step * step / 2); // between the samples
  for (double x : {0.0, 1.0, 3.33, 5.0})
    for (double y : {0.0, -2.2, 4.1}) {
      const double truth = std::sqrt((R + r) * (R + r) - x * x - y * y) - r;
      const double tip = index.drop(Tool::ball(1, 2 * r), x, y).tip;
      EXPECT_LE(tip, truth + 1e-5);
      EXPECT_GE(tip, truth - 1.2 * sink);
    }
}

TEST(PointIndex, AFlatOnASlopeTouchesWithItsRim)
{
  const Sampled slope(-10, 10, 0.1, [](double x, double) { return 0.5 * x; });
  const double tip = slope.index().drop(Tool::flat(1, 4.0), 0, 0).tip;
  EXPECT_NEAR(tip, 0.5 * 2.0, 1e-6); // z at x = +R
}

TEST(PointIndex, DropIsTheMaximumOverAllPoints)
{
  const Sampled cloud(-6, 6, 0.23, rough);
  const PointIndex index = cloud.index();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-9, 9); // beyond the rim as well
  for (const auto& tool : kTools)
    for (int i = 0; i < 200; ++i) {
      const double x = u(random), y = u(random);
      const auto contact = index.drop(tool, x, y);
      const double truth = brute::drop(cloud.points, tool, x, y);
      ASSERT_EQ(contact.touches(), std::isfinite(truth));
      if (contact.touches()) {
        EXPECT_NEAR(contact.tip, truth, 1e-12);
      }
    }
}

TEST(PointIndex, DropAlongIsTheMaximumOverTheMove)
{
  const Sampled cloud(-6, 6, 0.31, rough);
  const PointIndex index = cloud.index();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> u(-8, 8);
  for (const auto& tool : kTools)
    for (int i = 0; i < 60; ++i) {
      const double ax = u(random), ay = u(random);
      const double bx = i % 4 ? u(random) : ax, by = i % 5 ? u(random) : ay;
      double truth = -INFINITY;
      for (const auto& p : cloud.points)
        truth = std::max(truth,
                         p.z() - tool.profile(std::sqrt(pointmill::segmentDistance2(
                                     ax, ay, bx, by, p.x(), p.y()))));
      EXPECT_EQ(index.dropAlong(tool, ax, ay, bx, by), truth) << tool.describe();
    }
}

TEST(PointIndex, GougeIsTheDeepestOfAllPoints)
{
  const Sampled cloud(-6, 6, 0.31, rough);
  const PointIndex index = cloud.index();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-6, 6), h(-2, 5);
  int hits = 0;
  for (const auto& tool : kTools)
    for (int i = 0; i < 100; ++i) {
      const Vector3d a(u(random), u(random), h(random)),
          b(u(random), u(random), h(random));
      double truth = 0;
      for (const auto& p : cloud.points)
        truth = std::max(truth, pointmill::penetration(tool, a, b, p));
      EXPECT_NEAR(index.gouge(tool, a, b, 0.01), truth > 0.01 ? truth : 0.0, 1e-12);
      hits += truth > 0.01;
    }
  EXPECT_GT(hits, 50);
}

TEST(PointIndex, TheContactNormalOfABallPointsToItsCentre)
{
  Sampled one(0, 0, 1, [](double, double) { return 0; });
  const PointIndex index = one.index();
  const Tool ball = Tool::ball(1, 4.0);
  const auto contact = index.drop(ball, 1.0, 0.0);
  const Vector3d n = pointmill::contactNormal(ball, 1.0, 0.0, contact);
  EXPECT_NEAR(n.x(), 0.5, 1e-12);
  EXPECT_NEAR(n.z(), std::sqrt(0.75), 1e-12);
}

TEST(PointIndex, OddShapes)
{
  EXPECT_THROW(PointIndex({}, {}, {}), pointmill::DataError);
  Sampled line(0, 0, 1, [](double, double) { return 0; });
  for (int i = 1; i < 1000; ++i)
    line.add(i, 0, 0.001 * i); // no width at all
  EXPECT_NEAR(line.index().drop(Tool::ball(1, 2), 500, 0).tip, 0.5, 1e-3);
}
