// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "rough_test.h"

#include <set>

using namespace rough_test;

namespace {

template <typename S>
class RoughingLevels : public EveryRoughing<S> {
protected:
  const Rectangle area{0, 0, 30, 24};
  const Cloud::Ptr cloud = surface(area, 0.4, [](double x, double y) {
    return std::hypot(x - 15, y - 12) < 5 ? 0.0 : -6.1;
  });
};
TYPED_TEST_SUITE(RoughingLevels, Strategies, StrategyNames);

} // namespace

TYPED_TEST(RoughingLevels, AreTheStepDownApartAndTheLastIsTheFloor)
{
  this->set(Tool::flat(1, 6), 0.3, 1.2, 2.4);
  this->roughing.setFloor(-5.7);
  this->roughing.setStock(block(this->area, -6, 0));
  const auto passes = this->run(mapOf(this->cloud, 0.5));
  std::map<std::uint32_t, std::set<float>> heights;
  for (const auto& p : passes)
    heights[p.level].insert(p.z);
  ASSERT_EQ(heights.size(), 5u); // ceil(5.7 / 1.2)
  EXPECT_EQ(this->roughing.getReport().get("levels"), 5);
  EXPECT_EQ(this->roughing.getReport().get("levels_cut"), 5);
  for (const auto& [level, z] : heights) {
    ASSERT_EQ(z.size(), 1u) << level;
    EXPECT_FLOAT_EQ(*z.begin(), level < 4 ? -1.2f * float(level + 1) : -5.7f);
  }
  EXPECT_EQ(*heights[4].begin(), -5.7f);
}

TYPED_TEST(RoughingLevels, ComeFromTheTopDownAndPassesAreCountedThrough)
{
  this->set(Tool::flat(1, 6), 0.3, 1.2, 2.4);
  this->roughing.setStock(block(this->area, -6, 0));
  const auto passes = this->run(mapOf(this->cloud, 0.5));
  ASSERT_FALSE(passes.empty());
  EXPECT_EQ(passes.front().label, 0u);
  for (std::size_t i = 1; i < passes.size(); ++i) {
    EXPECT_GE(passes[i].level, passes[i - 1].level);
    EXPECT_LE(passes[i].label - passes[i - 1].label, 1u);
  }
  EXPECT_EQ(this->roughing.getReport().get("passes"), passes.back().label + 1.0);
  EXPECT_EQ(this->roughing.getReport().get("cl_points"), double(passes.size()));
}

TYPED_TEST(RoughingLevels, WithoutAStepDownLieAsInThePaper)
{
  // 0.3 d / 4
  this->set(Tool::flat(1, 8), 0.3, 0.0, 2.4);
  this->roughing.setFloor(-3);
  this->roughing.setStock(block(this->area, -6, 0));
  const auto passes = this->run(mapOf(this->cloud, 0.5));
  ASSERT_FALSE(passes.empty());
  EXPECT_EQ(this->roughing.getReport().get("levels"), 5);
  EXPECT_FLOAT_EQ(passes.front().z, -0.6f);
}

TYPED_TEST(RoughingLevels, ThatAreCoveredByThePartAreLeftOut)
{
  // Stock 0.2 mm above a flat plate of which 0.5 mm is to stay.
  const auto plate = surface({0, 0, 20, 20}, 0.5, [](double, double) { return 2; });
  this->set(Tool::flat(1, 6), 0.5, 0.1, 2.4);
  this->roughing.setStock(block({0, 0, 20, 20}, 0, 2.2));
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*plate) : nullptr);
    EXPECT_TRUE(this->run(mapOf(plate, 0.5)).empty());
    EXPECT_EQ(this->roughing.getReport().get("levels_cut"), 0);
  }
}

TYPED_TEST(RoughingLevels, ThatAreEmptyAreLeftOut)
{
  // The stock was cut down to -3 all over before: the levels above pass through air.
  const auto stock = block(this->area, -6, 0);
  const Tool shell = Tool::flat(9, 100);
  stock->cut(shell, Eigen::Vector3d(0, 12, -3), Eigen::Vector3d(30, 12, -3));
  this->set(Tool::flat(1, 6), 0.3, 1.0, 2.4);
  this->roughing.setFloor(-5);
  this->roughing.setStock(stock);
  const auto passes = this->run(mapOf(this->cloud, 0.5));
  ASSERT_FALSE(passes.empty());
  EXPECT_EQ(passes.front().level, 3u);
  EXPECT_EQ(this->roughing.getReport().get("levels"), 5);
  EXPECT_EQ(this->roughing.getReport().get("levels_cut"), 2);
}

TYPED_TEST(RoughingLevels, AFlatPlateGivesTheSameAtAnyHeight)
{
  // Without a stock of its own there is nothing above a plate; how high it lies in the
  // part frame must not matter.
  std::map<std::string, int> outcomes;
  for (const float z : {0.f, 2.f, 5.5f, -31.3f, 100.1f}) {
    const auto plate = surface({0, 0, 20, 20}, 0.5, [&](double, double) { return z; });
    this->set(Tool::flat(1, 6), 0.5, 0.1, 2.4);
    try {
      const auto passes = this->run(mapOf(plate, 0.5));
      ++outcomes[passes.empty() ? "no passes" : "passes"];
    }
    catch (const Error& e) {
      ++outcomes[e.what()];
    }
  }
  EXPECT_EQ(outcomes.size(), 1u) << ::testing::PrintToString(outcomes);
  EXPECT_EQ(outcomes.count("passes"), 0u);
}

TYPED_TEST(RoughingLevels, AreTheSameForAnyNumberOfThreads)
{
  const auto part = surface(this->area, 0.4, Bumps(this->area, 8, 12, 5));
  const auto map = mapOf(part, 0.4);
  this->set(Tool::flat(1, 5), 0.3, 0.8, 2.0);
  this->roughing.setStock(block(this->area, -1, 8));
  for (const bool exact : {false, true}) {
    this->roughing.setPart(exact ? indexOf(*part) : nullptr);
    this->roughing.setNumberOfThreads(1);
    const std::string one = bytes(this->run(map));
    ASSERT_GT(one.size(), 1000u);
    for (const unsigned threads : {2u, 5u}) {
      this->roughing.setNumberOfThreads(threads);
      EXPECT_EQ(bytes(this->run(map)), one) << threads;
    }
  }
}

TYPED_TEST(RoughingLevels, ASecondRunDoesNotRememberTheFirst)
{
  this->set(Tool::flat(1, 6), 0.3, 1.2, 2.4);
  const auto map = mapOf(this->cloud, 0.5);
  const std::string first = bytes(this->run(map));
  EXPECT_EQ(bytes(this->run(map)), first);
}
