// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "link_test.h"

#include <pointmill/link/path_figures.h>

#include <set>

using namespace link_test;

namespace {

const Cutting kCutting{8000, 1200, 300, true};

/// Passes over hills in a stock, so that feeds fall for descents and for heavy cuts.
CLCloud linked(double feed_step)
{
  const Stock stock{{0, 0, -12}, {60, 30, 0}};
  LinkPasses linker;
  linker.setTool(Tool::ball(1, 6));
  linker.setCutting(kCutting);
  linker.setClearancePlane(5);
  linker.setStock(fieldOf(stock));
  linker.setNominalStock(
      std::make_shared<StockField>(stock, 0.25, StockField::Bound::Nominal));
  linker.setFeedStep(feed_step);
  CLCloud passes;
  for (std::uint32_t row = 0; row < 8; ++row)
    for (double x = 0; x <= 60; x += 0.05) {
      passes.push_back(PointCL(x, 3 * row, -4 + 3 * std::sin(x / 5) + std::sin(x)));
      passes.back().label = row;
    }
  return link(linker, passes);
}

std::size_t changes(const CLCloud& path)
{
  std::size_t count = 0;
  float last = 0;
  for (const auto& p : path)
    if (p.feed > 0) {
      count += p.feed != last;
      last = p.feed;
    }
  return count;
}

/// The feeds of a pass of steps down by `size` and level moves of that length, in turn.
std::vector<float> stairs(double size)
{
  LinkPasses linker;
  linker.setTool(Tool::ball(1, 6));
  linker.setCutting(kCutting);
  linker.setClearancePlane(5);
  CLCloud passes;
  for (int i = 0; i < 20; ++i) {
    addPass(passes, 0, {{size * i, 0, -size * i}, {size * i, 0, -size * (i + 1)}});
  }
  std::vector<float> feeds;
  for (const auto& p : link(linker, passes))
    if (p.getMotion() == Motion::Cut)
      feeds.push_back(p.feed);
  return feeds;
}

} // namespace

TEST(FeedSteps, NeverRaiseAFeedAndCostLittleTime)
{
  const CLCloud own = linked(0), stepped = linked(0.05);
  ASSERT_EQ(own.size(), stepped.size());
  std::set<float> feeds;
  float lowest = 1e9f;
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(position(own[i]), position(stepped[i]));
    EXPECT_EQ(own[i].motion, stepped[i].motion);
    EXPECT_LE(stepped[i].feed, own[i].feed) << i;
    EXPECT_EQ(stepped[i].feed > 0, own[i].feed > 0) << i;
    if (own[i].feed > 0) {
      feeds.insert(stepped[i].feed);
      lowest = std::min(lowest, own[i].feed);
    }
  }
  // Steps from the full feed to the lowest, with two more for ramps and plunges.
  EXPECT_LE(feeds.size(), std::log(lowest / 1200) / std::log(0.95) + 4);
  EXPECT_EQ(feeds.count(1200), 1u);
  EXPECT_EQ(*feeds.begin(), lowest);
  EXPECT_LT(4 * changes(stepped), changes(own));
  EXPECT_LT(measurePath(stepped, 5000).minutes, 1.05 * measurePath(own, 5000).minutes);
}

TEST(FeedSteps, ChangeTheFeedOnlyWhereThatSavesTime)
{
  // On a level move of 2 mm 75 ms, more than two changes; on one of 0.02 mm less.
  const auto large = stairs(2), small = stairs(0.02);
  ASSERT_EQ(large.size(), 39u);
  ASSERT_EQ(small.size(), 39u);
  for (std::size_t i = 0; i < large.size(); ++i) {
    EXPECT_EQ(large[i], i % 2 ? 1200 : 300) << i;
    EXPECT_EQ(small[i], 300) << i;
  }
}
