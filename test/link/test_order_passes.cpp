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

TEST(OrderPasses, IsShorterThanAlwaysToTheNearest)
{
  for (const std::uint64_t seed : {8, 18, 28}) {
    const auto before = scattered(150, seed);
    auto left = byLevel(before);
    double nearest_first = 0;
    Eigen::Vector3d here = left.at(0).back();
    left.erase(0);
    while (!left.empty()) {
      double way = 1e9;
      std::uint32_t next = 0;
      bool turned = false;
      for (const auto& [level, points] : left)
        for (const bool back : {false, true}) {
          const auto& p = back ? points.back() : points.front();
          if ((p - here).head<2>().norm() < way) {
            way = (p - here).head<2>().norm();
            next = level;
            turned = back;
          }
        }
      nearest_first += way;
      here = turned ? left.at(next).front() : left.at(next).back();
      left.erase(next);
    }
    OrderPasses stage;
    const auto after = order(stage, before);
    EXPECT_LT(air(after), 0.95 * nearest_first) << seed;
    EXPECT_EQ(after.front().level, 0u) << "begins where the input begins";
  }
}

TEST(OrderPasses, LeavesNoTurnOfAFewPassesThatWouldSaveAir)
{
  OrderPasses stage;
  const auto after = order(stage, scattered(8, 4)); // all ends are neighbours
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> passes;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (i == 0 || after[i].label != after[i - 1].label)
      passes.emplace_back(position(after[i]), position(after[i]));
    passes.back().second = position(after[i]);
  }
  const auto way = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).head<2>().norm();
  };
  for (std::size_t i = 0; i + 1 < passes.size(); ++i)
    for (std::size_t j = i + 1; j < passes.size(); ++j) {
      double gain = way(passes[i].second, passes[i + 1].first) -
                    way(passes[i].second, passes[j].second);
      if (j + 1 < passes.size())
        gain += way(passes[j].second, passes[j + 1].first) -
                way(passes[i + 1].first, passes[j + 1].first);
      EXPECT_LE(gain, 1e-4) << i << " " << j;
    }
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
