// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/strays.h>
#include <pointmill/common/error.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>
#include <pcl/filters/radius_outlier_removal.h>

#include <cmath>

using namespace pointmill;
using pointmill_test::Random;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

pcl::Indices byPcl(const Cloud::Ptr& cloud, double radius, int company)
{
  pcl::RadiusOutlierRemoval<pcl::PointXYZ> filter;
  filter.setRadiusSearch(radius);
  filter.setMinNeighborsInRadius(company);
  filter.setInputCloud(cloud);
  pcl::Indices kept;
  filter.filter(kept);
  return kept;
}

/// A surface with a wall and a dense spot, dust over it and some grains far away.
Cloud::Ptr dustyPart(std::uint64_t seed)
{
  Random random(seed);
  Cloud::Ptr cloud(new Cloud);
  const auto add = [&](double x, double y, double z) {
    cloud->push_back(pcl::PointXYZ(float(x), float(y), float(z)));
  };
  for (int i = 0; i < 3000; ++i) {
    const double x = random.uniform(0, 30);
    add(x, random.uniform(0, 20), std::sin(x / 3));
  }
  for (int i = 0; i < 500; ++i)
    add(15, random.uniform(0, 20), random.uniform(0, 20));
  for (int i = 0; i < 200; ++i)
    add(3 + random.uniform(0, 0.01), 4 + random.uniform(0, 0.01), 0);
  for (int i = 0; i < 300; ++i)
    add(random.uniform(-5, 35), random.uniform(-5, 25), random.uniform(2, 30));
  for (int i = 0; i < 5; ++i)
    add(1e4 * random.uniform(), -1e4 * random.uniform(), 0);
  for (int i = 0; i < 10; ++i)
    cloud->push_back((*cloud)[static_cast<std::size_t>(i)]);
  return cloud;
}

} // namespace

TEST(Strays, ArePclsForAnyRadiusAndCompany)
{
  std::size_t some = 0;
  for (const std::uint64_t seed : {1, 2, 3})
    for (const double radius : {0.2, 1.0, 2.5, 40.0})
      for (const int company : {1, 6, 20}) {
        const auto cloud = dustyPart(seed);
        const auto kept = pointsInCompany(*cloud, radius, company);
        EXPECT_EQ(kept, byPcl(cloud, radius, company)) << radius << " " << company;
        some += !kept.empty() && kept.size() < cloud->size();
      }
  EXPECT_GT(some, 20u) << "nothing was tested";
}

TEST(Strays, PointsExactlyAtTheRadiusAreCompany)
{
  Cloud cloud;
  for (const float x : {0.f, 1.f, 2.f, 4.f})
    cloud.push_back(pcl::PointXYZ(x, 0, 0));
  EXPECT_EQ(pointsInCompany(cloud, 1.0, 1), (pcl::Indices{0, 1, 2}));
  EXPECT_EQ(pointsInCompany(cloud, 1.0, 2), (pcl::Indices{1}));
  EXPECT_EQ(pointsInCompany(cloud, 0.999, 0).size(), 4u);
}

TEST(Strays, ThePointsAreTheSameForAnyNumberOfThreads)
{
  const auto cloud = dustyPart(4);
  EXPECT_EQ(pointsInCompany(*cloud, 1.0, 6, 1), pointsInCompany(*cloud, 1.0, 6, 5));
}

TEST(Strays, WhatCannotBeAskedIsRefused)
{
  Cloud cloud;
  EXPECT_TRUE(pointsInCompany(cloud, 1.0, 6).empty());
  cloud.push_back(pcl::PointXYZ(0, 0, 0));
  EXPECT_THROW(pointsInCompany(cloud, 0.0, 6), ParameterError);
  EXPECT_THROW(pointsInCompany(cloud, std::nan(""), 6), ParameterError);
  EXPECT_THROW(pointsInCompany(cloud, 1.0, -1), ParameterError);
  cloud.push_back(pcl::PointXYZ(0, std::nanf(""), 0));
  EXPECT_THROW(pointsInCompany(cloud, 1.0, 6), DataError);
}
