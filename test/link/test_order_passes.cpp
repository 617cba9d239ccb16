// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "link_test.h"

#include <pointmill/link/order_passes.h>

#include <map>

using namespace link_test;

namespace {

CLCloud order(OrderPasses& stage, const CLCloud& passes)
{
  CLCloud output;
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  stage.filter(output);
  return output;
}

/// Short passes of 1 to 5 points at random places.
CLCloud scattered(int count, std::uint64_t seed)
{
  Random random(seed);
  CLCloud passes;
  for (int label = 0; label < count; ++label) {
    const double x = random.uniform(0, 100), y = random.uniform(0, 60);
    const int points = 1 + static_cast<int>(random.uniform(0, 5));
    for (int i = 0; i < points; ++i) {
      passes.push_back(PointCL(x + 2 * i, y, random.uniform(-5, 0)));
      passes.back().label = static_cast<std::uint32_t>(label);
      passes.back().level = static_cast<std::uint32_t>(label); // tells where it was
    }
  }
  return passes;
}

std::map<std::uint32_t, std::vector<Eigen::Vector3d>> byLevel(const CLCloud& passes)
{
  std::map<std::uint32_t, std::vector<Eigen::Vector3d>> all;
  for (const auto& p : passes)
    all[p.level].push_back(position(p));
  return all;
}

double air(const CLCloud& passes)
{
  double sum = 0;
  for (std::size_t i = 1; i < passes.size(); ++i)
    if (passes[i].label != passes[i - 1].label)
      sum += (position(passes[i]) - position(passes[i - 1])).head<2>().norm();
  return sum;
}

} // namespace

TEST(OrderPasses, KeepsEveryPassWholeForwardOrBackward)
{
  OrderPasses stage;
  const auto before = scattered(200, 7);
  const auto after = order(stage, before);
  ASSERT_EQ(after.size(), before.size());
  const auto was = byLevel(before);
  int reversed = 0;
  for (auto [level, points] : byLevel(after)) {
    if (points != was.at(level)) {
      std::reverse(points.begin(), points.end());
      ++reversed;
    }
    EXPECT_EQ(points, was.at(level)) << level;
  }
  EXPECT_GT(reversed, 20);
  for (std::size_t i = 1; i < after.size(); ++i)
    EXPECT_EQ(after[i].label - after[i - 1].label,
              after[i].level == after[i - 1].level ? 0u : 1u);
  EXPECT_EQ(after.front().label, 0u);
  EXPECT_EQ(after.back().label, 199u);
}

TEST(OrderPasses, GoesFromEachEndToTheNearestOfAllThatAreLeft)
{
  OrderPasses stage;
  const auto before = scattered(60, 8);
  auto left = byLevel(before);
  const auto after = order(stage, before);
  EXPECT_EQ(after.front().level, 0u) << "begins where the input begins";
  left.erase(0);
  for (std::size_t i = 1; i < after.size(); ++i) {
    if (after[i].label == after[i - 1].label)
      continue;
    const auto here = position(after[i - 1]);
    double nearest = 1e9;
    for (const auto& pass : left)
      for (const auto& p : {pass.second.front(), pass.second.back()})
        nearest = std::min(nearest, (p - here).head<2>().norm());
    EXPECT_NEAR((position(after[i]) - here).head<2>().norm(), nearest, 1e-5) << i;
    left.erase(after[i].level);
  }
  EXPECT_TRUE(left.empty());
}

TEST(OrderPasses, SavesAirAndReportsIt)
{
  OrderPasses stage;
  const auto before = scattered(200, 9);
  const auto after = order(stage, before);
  EXPECT_LT(air(after), air(before) / 4);
  EXPECT_NEAR(stage.getReport().get("air_before_mm"), air(before), 1e-3);
  EXPECT_NEAR(stage.getReport().get("air_after_mm"), air(after), 1e-3);
}

TEST(OrderPasses, OfOnePassIsThatPass)
{
  OrderPasses stage;
  CLCloud one;
  addPass(one, 4, {{1, 2, 3}, {4, 5, 6}});
  const auto after = order(stage, one);
  ASSERT_EQ(after.size(), 2u);
  EXPECT_EQ(after[0].x, 1.f);
  EXPECT_EQ(after[0].label, 0u);
}

TEST(OrderPasses, WorksOnTheIndicesGivenAndRefusesNothingAtAll)
{
  OrderPasses stage;
  CLCloud passes;
  addPass(passes, 0, {{0, 0, 0}, {1, 0, 0}});
  addPass(passes, 1, {{50, 0, 0}, {51, 0, 0}});
  addPass(passes, 2, {{3, 0, 0}, {2, 0, 0}});
  stage.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1, 4, 5}));
  const auto after = order(stage, passes);
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[2].x, 2.f);
  EXPECT_EQ(after[3].x, 3.f);
  OrderPasses fresh;
  CLCloud output(after);
  fresh.setInputCloud(CLCloud::ConstPtr(new CLCloud));
  EXPECT_THROW(fresh.filter(output), DataError);
  passes[0].x = std::nanf("");
  fresh.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  EXPECT_THROW(fresh.filter(output), DataError);
  EXPECT_EQ(output.size(), 4u);
}
