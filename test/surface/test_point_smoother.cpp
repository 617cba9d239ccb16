// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Noise is taken off, edges and gouge bounds are kept.
#include <pointmill/surface/point_smoother.h>
#include <pointmill/surface/surface_model.h>
#include <pointmill_test/clouds.h>
#include <pointmill_test/freeform.h>

#include <gtest/gtest.h>

#include <cstring>

using namespace pointmill_test;
using pointmill::PointSmoother;
using pointmill::SmoothSurface;
using pointmill::SurfaceModel;
using pointmill::Tool;

namespace {

Cloud smoothed(const Cloud::ConstPtr& cloud,
               double noise,
               int neighbours,
               pointmill::Report* report = nullptr,
               unsigned threads = 0)
{
  PointSmoother<pcl::PointXYZ> smoother;
  smoother.setNoise(noise);
  smoother.setNeighbours(neighbours);
  smoother.setNumberOfThreads(threads);
  smoother.setInputCloud(cloud);
  Cloud output;
  smoother.filter(output);
  if (report)
    *report = smoother.getReport();
  return output;
}

/// A step 3 mm high at x = 10, with noise along Z.
Cloud::Ptr noisyStep(double noise)
{
  Random random(2);
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 40000; ++i) {
    const double x = random.uniform(0, 20), y = random.uniform(0, 20);
    cloud->push_back(
        {float(x), float(y), float((x < 10 ? 3 : 0) + noise * random.normal())});
  }
  return cloud;
}

} // namespace

TEST(PointSmoother, GivesTheTrueSurfaceOfANoisyFreeform)
{
  // The noise of a poor scanner: 0.05 mm at 100 points/mm2. Resting on its bare points
  // the ball floats on the peaks, about two deviations too high.
  const double noise = 0.05, edge = 30;
  const auto cloud = Freeform::sample(90000, edge, noise, 3);
  pointmill::Report report;
  const Cloud clean = smoothed(cloud, noise, 300, &report);
  const SurfaceModel raw(indexOf(*cloud));
  const SurfaceModel model(indexOf(clean), SmoothSurface{24, 0.01});
  const Tool ball = Tool::ball(1, 3);
  double mean = 0, square = 0, floats = 0;
  int count = 0;
  for (double y = 3; y < edge - 3; y += 0.31)
    for (double x = 3; x < edge - 3; x += 0.29) {
      const double truth = Freeform::tip(1.5, x, y);
      const double error = model.drop(ball, x, y).tip - truth;
      mean += error;
      square += error * error;
      floats += raw.drop(ball, x, y).tip - truth;
      ++count;
    }
  EXPECT_GT(floats / count, 1.4 * noise);
  EXPECT_LT(std::abs(mean / count), 0.003);
  EXPECT_LT(std::sqrt(square / count), 0.010);
  EXPECT_NEAR(report.get("noise_left_mm"), 2 * noise / std::sqrt(300.0), 0.002);
  EXPECT_GT(report.get("on_surface"), 0.99 * double(cloud->size()));
}

TEST(PointSmoother, MovesNoPointFurtherThanThreeTimesTheNoise)
{
  auto cloud = Freeform::sample(20000, 20, 0.02, 8);
  for (std::size_t i = 0; i < cloud->size(); i += 1000)
    (*cloud)[i].z += 0.5f; // not noise
  const Cloud clean = smoothed(cloud, 0.02, 100);
  ASSERT_EQ(clean.size(), cloud->size());
  for (std::size_t i = 0; i < clean.size(); ++i) {
    const auto moved = clean[i].getVector3fMap() - (*cloud)[i].getVector3fMap();
    EXPECT_LE(moved.norm(), 0.06 + 1e-5);
  }
  // A stray point stays a stray point, less the distance.
  EXPECT_GT(clean[1000].z - Freeform::height(clean[1000].x, clean[1000].y), 0.3);
}

TEST(PointSmoother, KeepsAStepSharp)
{
  const double noise = 0.02;
  pointmill::Report report;
  const auto cloud = noisyStep(noise);
  const Cloud clean = smoothed(cloud, noise, 200, &report);
  double worst = 0, square = 0;
  int beside = 0;
  for (const auto& p : clean) {
    if (std::abs(p.x - 10) > 0.5 || p.y < 1 || p.y > 19)
      continue;
    const double error = p.z - (p.x < 10 ? 3 : 0);
    worst = std::max(worst, std::abs(error));
    square += error * error;
    ++beside;
  }
  ASSERT_GT(beside, 1000);
  EXPECT_LT(worst, 3 * noise);
  EXPECT_LT(std::sqrt(square / beside), 0.6 * noise);
}

TEST(PointSmoother, KeepsACreaseWithinTheTolerance)
{
  // A roof with a right angle, noise 0.02 mm: its ridge must not be rounded by more
  // than 0.02 mm.
  Random random(6);
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 90000; ++i) {
    const double x = random.uniform(0, 20), y = random.uniform(0, 20);
    cloud->push_back(
        {float(x), float(y), float(5 - std::abs(x - 10) + 0.02 * random.normal())});
  }
  const Cloud clean = smoothed(cloud, 0.02, 200);
  double sum = 0, lowest = 1;
  int count = 0;
  for (const auto& p : clean)
    if (std::abs(p.x - 10) < 0.1 && p.y > 1 && p.y < 19) {
      const double error = p.z - (5 - std::abs(p.x - 10));
      sum += error;
      lowest = std::min(lowest, error);
      ++count;
    }
  ASSERT_GT(count, 500);
  EXPECT_GT(sum / count, -0.01);
  EXPECT_LT(sum / count, 0.01);
}

TEST(PointSmoother, LeavesCleanPointsOnTheirSurface)
{
  const auto cloud = Freeform::sample(40000, 20, 0, 8);
  const Cloud clean = smoothed(cloud, 0.001, 60);
  for (const auto& p : clean)
    EXPECT_NEAR(p.z, Freeform::height(p.x, p.y), 0.0035);
}

TEST(PointSmoother, IsAPclFilter)
{
  auto cloud = Freeform::sample(5000, 10, 0.02, 8);
  (*cloud)[7].z = std::nanf("");
  cloud->is_dense = false;
  pcl::PointCloud<pcl::PointXYZI>::Ptr coloured(new pcl::PointCloud<pcl::PointXYZI>);
  for (const auto& p : *cloud) {
    pcl::PointXYZI q;
    q.x = p.x, q.y = p.y, q.z = p.z, q.intensity = 42;
    coloured->push_back(q);
  }
  PointSmoother<pcl::PointXYZI> smoother;
  smoother.setNoise(0.02);
  pcl::Filter<pcl::PointXYZI>& filter = smoother;
  filter.setInputCloud(coloured);
  pcl::IndicesPtr some(new pcl::Indices);
  for (int i = 0; i < 4000; ++i)
    some->push_back(i);
  smoother.setIndices(some);
  pcl::PointCloud<pcl::PointXYZI> output;
  smoother.filter(output);
  EXPECT_EQ(output.size(), 3999u);
  EXPECT_TRUE(output.is_dense);
  EXPECT_EQ(output[100].intensity, 42);
  EXPECT_EQ(smoother.getReport().get("nan_points"), 1);
}

TEST(PointSmoother, IsTheSameForAnyNumberOfThreads)
{
  const auto cloud = Freeform::sample(8000, 15, 0.02, 8);
  const Cloud one = smoothed(cloud, 0.02, 60, nullptr, 1);
  const Cloud many = smoothed(cloud, 0.02, 60, nullptr, 5);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(0, std::memcmp(&one[i], &many[i], sizeof one[i]));
}
