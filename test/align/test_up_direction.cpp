// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/up_direction.h>
#include <pointmill/common/error.h>
#include <pointmill_test/random.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <string>

using namespace pointmill::align;
using pointmill_test::Random;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;
const Eigen::Vector3d no_hint = Eigen::Vector3d::Zero();

// A plate of 80 x 50 with a square boss, 8 high over a share of its area, or a pocket.
Points plate(double height, double noise, int count = 20000)
{
  Random random(1);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-40, 40), y = random.uniform(-25, 25);
    const bool inside = std::abs(x - 5) < 12 && std::abs(y + 3) < 12;
    points.emplace_back(x, y, (inside ? height : 0) + noise * random.normal());
  }
  return points;
}

Points turned(Points points, const Eigen::Matrix3d& r)
{
  for (auto& p : points)
    p = r * p;
  return points;
}

Eigen::Matrix3d anyRotation(Random& random)
{
  Eigen::Quaterniond q(
      random.normal(), random.normal(), random.normal(), random.normal());
  return q.normalized().toRotationMatrix();
}

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.cross(b).norm() > 0 || a.dot(b) > 0 ? std::atan2(a.cross(b).norm(), a.dot(b))
                                               : 180 * degree;
}

} // namespace

TEST(UpDirection, TheBaseIsBelowTheBosses)
{
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d r = anyRotation(random);
    const UpDirection up =
        baseNormal(turned(plate(8, 0.02), r), PlaneSearch(), no_hint, "test");
    EXPECT_LT(angle(up.axis, r.col(2)), 0.002 * degree);
    EXPECT_NEAR(up.base_share, 1 - 24.0 * 24.0 / 4000.0, 0.01);
    EXPECT_NEAR(up.evidence, 1, 1e-9);
  }
}

TEST(UpDirection, TheHintDecidesForAFlatPlate)
{
  const Points flat = plate(0, 0.02);
  EXPECT_GT(baseNormal(flat, PlaneSearch(), {0, 1, 9}, "test").axis.z(), 0.999);
  EXPECT_LT(baseNormal(flat, PlaneSearch(), {0, 1, -9}, "test").axis.z(), -0.999);
  EXPECT_GT(baseNormal(flat, PlaneSearch(), no_hint, "test").axis.z(), 0.999);
  EXPECT_GT(thinnestDirection(flat, no_hint, "test").axis.z(), 0.999);
  EXPECT_LT(thinnestDirection(flat, {1, 0, -1}, "test").axis.z(), -0.999);
}

TEST(UpDirection, AReliefStandsOutOfItsGround)
{
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d r = anyRotation(random);
    const UpDirection up =
        thinnestDirection(turned(plate(2, 0.02), r), no_hint, "test");
    EXPECT_LT(angle(up.axis, r.col(2)), 1 * degree);
    EXPECT_GT(up.evidence, 0.5);
  }
}

TEST(UpDirection, WhatHasNoDirectionIsRefused)
{
  Points line, ball;
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    line.emplace_back(Eigen::Vector3d(1, 2, 3) * random.uniform());
    ball.emplace_back(random.normal(), random.normal(), random.normal());
    ball.back() *= 20 / ball.back().norm();
  }
  EXPECT_THROW(baseNormal(line, PlaneSearch(), no_hint, "test"), pointmill::DataError);
  EXPECT_THROW(thinnestDirection(line, no_hint, "test"), pointmill::DataError);
  try {
    baseNormal(ball, PlaneSearch(), no_hint, "Finder");
    FAIL() << "a ball has a base";
  }
  catch (const pointmill::DataError& e) {
    EXPECT_NE(std::string(e.what()).find("Finder: the largest plane"),
              std::string::npos);
  }
  Points cube;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1})
        cube.emplace_back(x, y, z);
  EXPECT_THROW(thinnestDirection(cube, no_hint, "test"), pointmill::DataError);
}

TEST(UpDirection, TheSamePointsYieldTheSameBits)
{
  const Points points = plate(8, 0.02, 50000);
  const UpDirection once = baseNormal(points, PlaneSearch(), no_hint, "test");
  const UpDirection again = baseNormal(points, PlaneSearch(), no_hint, "test");
  EXPECT_EQ(once.axis, again.axis);
  EXPECT_EQ(once.base_share, again.base_share);
}
