// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/sweep.h>

#include <brute_force.h>
#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pointmill_test/random.h>

#include <random>
#include <set>

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
      const double height = index.dropAlong(tool, ax, ay, bx, by);
      ASSERT_EQ(std::isfinite(height), std::isfinite(truth));
      if (std::isfinite(truth)) {
        EXPECT_NEAR(height, truth, 1e-12) << tool.describe();
      }
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

TEST(PointIndex, WhatCannotBeIndexedIsRefused)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(PointIndex({}, {}, {}), pointmill::DataError);
  EXPECT_THROW(PointIndex({1, 2}, {1, 2}, {1}), pointmill::DataError);
  EXPECT_THROW(PointIndex({1, 2}, {1, nan}, {1, 2}), pointmill::DataError);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back({nan, 1, 1});
  EXPECT_THROW(PointIndex({pointmill::pointSource(cloud)}), pointmill::DataError);
}

TEST(PointIndex, OfACloudTakesTheFinitePointsThatAreNamed)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::PointCloud<pcl::PointNormal> fill;
  for (int i = 0; i < 10; ++i)
    cloud.push_back({float(i), float(i % 3), i == 4 ? nan : float(10 * i)});
  pcl::PointNormal bridge;
  bridge.x = 2, bridge.y = 2, bridge.z = 55;
  fill.push_back(bridge);
  const pcl::Indices some{8, 4, 2, 2, 5};
  const PointIndex index = pointmill::makePointIndex(cloud, some, fill);
  std::multiset<double> heights;
  for (std::size_t i = 0; i < index.size(); ++i)
    heights.insert(index.point(i).z());
  EXPECT_EQ(heights, (std::multiset<double>{20, 20, 50, 55, 80}));
  EXPECT_EQ(index.min(), Vector3d(2, 2, 20));
  EXPECT_EQ(index.max(), Vector3d(8, 2, 80));
}

TEST(PointIndex, CellsHoldAllPointsOnceWhereTheyBelong)
{
  const Sampled cloud(-6, 6, 0.17, rough);
  const PointIndex index = cloud.index();
  std::size_t next = 0;
  for (int row = 0; row < index.rows(); ++row)
    for (int column = 0; column < index.columns(); ++column) {
      const auto [first, last] = index.cells(row, column, column);
      ASSERT_EQ(first, next);
      for (std::size_t i = first; i < last; ++i) {
        EXPECT_EQ(index.columnOf(index.point(i).x()), column);
        EXPECT_EQ(index.rowOf(index.point(i).y()), row);
      }
      next = last;
    }
  EXPECT_EQ(next, cloud.points.size());
}

TEST(PointIndex, RandomPointsLetABallSinkByAKnownMean)
{
  // A ball sinks by h between points where a disc of area 2 pi R h around the contact
  // is empty: with density rho, the mean of h is 1 / (2 pi rho R).
  const double size = 120, density = 10, radius = 1.5;
  pointmill_test::Random random(3);
  std::vector<float> x, y, z;
  for (int i = 0; i < int(size * size * density); ++i) {
    x.push_back(float(random.uniform(0, size)));
    y.push_back(float(random.uniform(0, size)));
    z.push_back(0);
  }
  const PointIndex index(x, y, z);
  constexpr int n = 400;
  std::vector<pointmill::Contact> row(n);
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    index.dropRow(
        Tool::ball(1, 2 * radius), {3, 3 + 0.285 * j}, {0.285, 0}, n, row.data());
    for (const auto& contact : row)
      sum -= contact.tip;
  }
  const double mean = 1 / (2 * 3.14159265358979 * density * radius); // 10.6 um
  EXPECT_NEAR(sum / (n * n), mean, 0.03 * mean);
}

TEST(PointIndex, OddShapes)
{
  Sampled line(0, 0, 1, [](double, double) { return 0; });
  for (int i = 1; i < 1000; ++i)
    line.add(i, 0, 0.001 * i); // no width at all
  EXPECT_NEAR(line.index().drop(Tool::ball(1, 2), 500, 0).tip, 0.5, 1e-3);
}
