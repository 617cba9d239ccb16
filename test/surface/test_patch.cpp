// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Quadrics fitted to neighbourhoods.
#include <pointmill/surface/patch.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

using namespace pointmill_test;
using Eigen::Vector3d;
using pointmill::Neighbourhood;
using pointmill::Patch;

namespace {

Cloud::Ptr
randomPoints(std::size_t count, double edge, double (*height)(double, double))
{
  Random random(11);
  Cloud::Ptr cloud(new Cloud);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge);
    cloud->push_back({float(x), float(y), float(height(x, y))});
  }
  return cloud;
}

double saddle(double x, double y)
{
  return 3 + 0.2 * x - 0.4 * y + 0.05 * x * x - 0.03 * x * y - 0.04 * y * y;
}

} // namespace

TEST(Neighbourhood, HoldsAllPointsWithinItsRadiusAndNoOthers)
{
  const auto cloud = randomPoints(5000, 20, saddle);
  const auto index = indexOf(*cloud);
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const double x = random.uniform(-1, 21), y = random.uniform(-1, 21);
    const Vector3d place(x, y, saddle(x, y) + random.uniform(-0.5, 0.5));
    Neighbourhood near;
    near.gather(*index, place, 30);
    std::size_t inside = 0;
    for (const auto& p : *cloud)
      inside += (p.getVector3fMap().cast<double>() - place).norm() <= near.radius;
    EXPECT_EQ(near.size(), inside);
    EXPECT_GT(near.size(), 15u);
    EXPECT_LT(near.size(), 90u);
  }
}

TEST(Neighbourhood, TakesAllPointsWhereThereAreFewer)
{
  const auto index = indexOf(*randomPoints(7, 20, saddle));
  Neighbourhood near;
  near.gather(*index, {100, 100, 0}, 24);
  EXPECT_EQ(near.size(), 7u);
}

TEST(Neighbourhood, CountsAlongAWallNotAcrossIt)
{
  // Seen from above the wall's points lie on one line.
  Cloud cloud;
  for (int i = 0; i <= 200; ++i)
    for (int k = 0; k <= 200; ++k)
      cloud.push_back(pcl::PointXYZ(0.1f * i, 5.f, 0.1f * k));
  const auto index = indexOf(cloud);
  Neighbourhood near;
  near.gather(*index, {10, 5, 10}, 40);
  EXPECT_GT(near.size(), 20u);
  EXPECT_LT(near.size(), 120u);
  EXPECT_NEAR(std::abs(near.planeNormal().y()), 1, 1e-9);
}

TEST(Patch, IsTheQuadricThatThePointsLieOn)
{
  const auto index = indexOf(*randomPoints(20000, 20, saddle));
  for (const Vector3d& normal : {Vector3d(0, 0, 1), Vector3d(0.2, -0.1, 1)}) {
    Neighbourhood near;
    near.gather(*index, {9, 11, saddle(9, 11)}, 60);
    Patch patch;
    ASSERT_TRUE(patch.fit(near, normal.normalized()));
    // In a turned frame it is no longer exactly a quadric.
    const double error = normal.x() == 0 ? 2e-6 : 3e-4;
    EXPECT_LT(patch.residual(), error);
    for (const double s : {-0.3, 0.0, 0.3})
      for (const double t : {-0.2, 0.1}) {
        const Vector3d p = patch.at(s, t);
        EXPECT_NEAR(p.z(), saddle(p.x(), p.y()), error);
        const Vector3d n = patch.normalAt(s, t);
        const Vector3d truth(
            -0.2 - 0.1 * p.x() + 0.03 * p.y(), 0.4 + 0.03 * p.x() + 0.08 * p.y(), 1);
        EXPECT_LT(n.cross(truth.normalized()).norm(), 100 * error);
        EXPECT_LT((patch.project(p) - Eigen::Vector2d(s, t)).norm(), 1e-12);
      }
  }
}

TEST(Patch, TellsTheNoiseOfItsPointsAndWhatIsLeftOfIt)
{
  Random random(5);
  double residual2 = 0, value2 = 0, variance = 0;
  const int trials = 400;
  for (int k = 0; k < trials; ++k) {
    Cloud cloud;
    for (int i = 0; i < 60; ++i)
      cloud.push_back(pcl::PointXYZ(float(random.uniform(-1, 1)),
                                    float(random.uniform(-1, 1)),
                                    float(0.1 * random.normal())));
    Neighbourhood near;
    near.gather(*indexOf(cloud), {0, 0, 0}, 60);
    Patch patch;
    ASSERT_TRUE(patch.fit(near, Vector3d::UnitZ()));
    residual2 += patch.residual() * patch.residual();
    value2 += patch.height(0, 0) * patch.height(0, 0);
    variance += patch.variance();
  }
  EXPECT_NEAR(std::sqrt(residual2 / trials), 0.1, 0.003);
  EXPECT_NEAR(value2 / trials / 0.01, variance / trials, 0.02);
}

TEST(Patch, KnowsWhereItsPointsEnd)
{
  const auto index =
      indexOf(*surface({0, 0, 4, 4}, 0.2, [](double x, double) { return 0.3 * x; }));
  Neighbourhood near;
  near.gather(*index, {0, 2, 0}, 24);
  Patch patch;
  ASSERT_TRUE(patch.fit(near, Vector3d::UnitZ()));
  const auto between = [&](double x, double y) {
    const auto st = patch.project({x, y, 0.3 * x});
    return patch.isBetween(near, st.x(), st.y());
  };
  EXPECT_TRUE(between(0.1, 2));
  EXPECT_TRUE(between(0.1, 1.9));
  EXPECT_FALSE(between(-0.1, 2));
  EXPECT_FALSE(between(-0.4, 2.2));
}

TEST(Patch, RefusesPointsThatDetermineNone)
{
  Cloud line, few;
  for (int i = 0; i < 30; ++i)
    line.push_back(pcl::PointXYZ(0.1f * i, 0.2f * i, 0));
  for (int i = 0; i < 7; ++i)
    few.push_back(pcl::PointXYZ(float(i % 3), float(i / 3), 0));
  for (const auto* cloud : {&line, &few}) {
    Neighbourhood near;
    near.gather(*indexOf(*cloud), {1, 1, 0}, 30);
    Patch patch;
    EXPECT_FALSE(patch.fit(near, Vector3d::UnitZ()));
  }
}
