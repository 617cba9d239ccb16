// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "freeform.h"

#include <pointmill/common/error.h>
#include <pointmill/slice/noise.h>
#include <pointmill/slice/sink.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pointmill;
using pointmill_test::freeformScan;
using pointmill_test::Random;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

Cloud plane(double edge, double density, double noise)
{
  Random random(2);
  Cloud cloud;
  for (int i = 0; i < int(edge * edge * density); ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge);
    cloud.push_back({float(x), float(y), float(noise * random.normal())});
  }
  return cloud;
}

Cloud sphere(double radius, int count, double noise)
{
  Random random(4);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    const double r = (radius + noise * random.normal()) / std::hypot(x, y, z);
    cloud.push_back({float(r * x), float(r * y), float(r * z)});
  }
  return cloud;
}

} // namespace

TEST(Noise, OfAPlaneAtAnyDensity)
{
  // From neighbours much farther apart than the noise to much nearer than it.
  for (const double density : {1.0, 10.0, 100.0, 1000.0}) {
    const double edge = std::sqrt(50000 / density);
    EXPECT_NEAR(measureNoise(plane(edge, density, 0.05)).deviation, 0.05, 0.003)
        << density;
  }
}

TEST(Noise, OfAPlaneThatStands)
{
  Cloud cloud = plane(50, 10, 0.05);
  for (auto& p : cloud)
    std::swap(p.x, p.z);
  EXPECT_NEAR(measureNoise(cloud).deviation, 0.05, 0.003);
}

TEST(Noise, OfAFreeformSurface)
{
  for (const double noise : {0.02, 0.05})
    EXPECT_NEAR(
        measureNoise(freeformScan(50, 100, noise)).deviation, noise, 0.06 * noise);
}

TEST(Noise, OfAClosedSurface)
{
  EXPECT_NEAR(measureNoise(sphere(20, 200000, 0.05)).deviation, 0.05, 0.003);
  EXPECT_LT(measureNoise(sphere(20, 200000, 0)).deviation, 1e-5);
}

TEST(Noise, OfStepsIsThatOfTheirTreads)
{
  Cloud cloud = plane(50, 40, 0.02);
  for (auto& p : cloud)
    p.z += std::floor(p.x / 10) * 5;
  EXPECT_NEAR(measureNoise(cloud).deviation, 0.02, 0.002);
}

TEST(Noise, OfQuantisedHeightsIsThatOfQuanta)
{
  // Heights rounded to 0.1 on a slope of several quanta from point to point.
  Cloud cloud = plane(50, 10, 0);
  for (auto& p : cloud)
    p.z = std::round((0.7f * p.x + 0.3f * p.y) / 0.1f) * 0.1f;
  const double along_normal = 0.1 / std::sqrt(12.0) / std::hypot(1.0, 0.7, 0.3);
  EXPECT_NEAR(measureNoise(cloud).deviation, along_normal, 0.1 * along_normal);
}

TEST(Noise, PointsThatAreThereTwiceTellNothingNew)
{
  Cloud cloud = plane(50, 10, 0.05);
  cloud += Cloud(cloud);
  cloud += Cloud(cloud);
  EXPECT_NEAR(measureNoise(cloud).deviation, 0.05, 0.003);
}

TEST(Noise, IsNotSeenWhereThereIsNone)
{
  EXPECT_LT(measureNoise(freeformScan(50, 100, 0)).deviation, 1e-3);
  // Form between sparse points looks like noise, but grows: none is taken for it
  // beyond a hundredth of what a ball end mill sinks there.
  const double sink = sinkBetweenPoints(Tool::ball(1, 3), 1.0);
  const Noise sparse = measureNoise(freeformScan(100, 1, 0));
  EXPECT_LT(sparse.deviation, 0.01 * sink);
  EXPECT_GT(sparse.scatter, 0.05 * sink);
}

TEST(Noise, IsToldFromFormBetweenSparsePoints)
{
  EXPECT_NEAR(measureNoise(freeformScan(100, 1, 0.05)).deviation, 0.05, 0.005);
}

TEST(Noise, IsTheSameEachTime)
{
  const Cloud cloud = freeformScan(30, 50, 0.03);
  const Noise a = measureNoise(cloud, 5), b = measureNoise(cloud, 5);
  EXPECT_EQ(a.deviation, b.deviation);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_NEAR(measureNoise(cloud, 6).deviation, a.deviation, 0.05 * a.deviation);
}

TEST(Noise, OfTooFewPointsIsRefused)
{
  EXPECT_THROW(measureNoise({}), DataError);
  Cloud same(20, 1, pcl::PointXYZ(1, 2, 3));
  EXPECT_THROW(measureNoise(same), DataError);
  Cloud few = plane(3, 1, 0.1);
  few.resize(7);
  EXPECT_THROW(measureNoise(few), DataError);
}
