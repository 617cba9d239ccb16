// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/point_recovery.h>
#include <pointmill/slice/z_slices.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pointmill;

TEST(ZSlices, PitchAndCountOfThePaper)
{
  ZSlices slices;
  slices.setZLimits(-10, 0);
  slices.setPitchForDiameter(10); // 0.75 mm: ceil(10 / 0.75) = 14
  const auto levels = slices.levels();
  ASSERT_EQ(levels.size(), 14u);
  EXPECT_DOUBLE_EQ(levels.front(), -0.75);
  EXPECT_EQ(levels.back(), -10.0);
}

TEST(ZSlices, AWholeNumberOfPitchesIsNotRoundedUp)
{
  ZSlices slices;
  slices.setZLimits(0, 0.3);
  slices.setPitch(0.1); // 0.3 / 0.1 = 2.9999999999999996
  EXPECT_EQ(slices.levels().size(), 3u);
  slices.setZLimits(-2.1, 0);
  slices.setPitch(0.7); // 2.1 / 0.7 = 3.0000000000000004
  EXPECT_EQ(slices.levels().size(), 3u);
}

TEST(ZSlices, RefusesNonsense)
{
  ZSlices slices;
  slices.setZLimits(0, 0);
  EXPECT_THROW(slices.levels(), ParameterError);
  slices.setZLimits(0, 10);
  slices.setPitch(0);
  EXPECT_THROW(slices.levels(), ParameterError);
  slices.setPitch(std::nan(""));
  EXPECT_THROW(slices.levels(), ParameterError);
}

TEST(PointRecovery, KeepsWhatIsAboveOnThePlane)
{
  pcl::PointCloud<pcl::PointXYZI>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZI>);
  for (float z : {0.f, 1.f, 2.f, 3.f, std::numeric_limits<float>::quiet_NaN()}) {
    pcl::PointXYZI p;
    p.x = z;
    p.z = z;
    p.intensity = 7;
    cloud->push_back(p);
  }
  PointRecovery<pcl::PointXYZI> recovery;
  recovery.setLevel(1.0);
  recovery.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZI> out;
  recovery.filter(out);
  ASSERT_EQ(out.size(), 2u);
  for (const auto& p : out) {
    EXPECT_EQ(p.z, 1.f);
    EXPECT_EQ(p.intensity, 7.f);
  }
  EXPECT_EQ(recovery.getReport().get("nan_points"), 1);

  recovery.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 3}));
  recovery.filter(out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].x, 3.f);
}
