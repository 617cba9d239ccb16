// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Zones where no tool may be, and rapids whose axes do not arrive at once.
#include "verify_test.h"

using namespace verify_test;

namespace {

/// A plate of 30 x 20 at -2 in a stock that reaches up to 0; a clamp of 10 x 8 on its
/// far corner, 6 high. It stands beside the stock as well.
struct Clamped : ::testing::Test {
  const Rectangle area{0, 0, 30, 20};
  const Cloud::Ptr cloud = surface(area, 0.5, [](double, double) { return -2; });
  ProgramVerifier verifier;

  Clamped()
  {
    verifier.setPart(indexOf(*cloud));
    verifier.setStock({{0, 0, -3}, {30, 20, 0}});
    verifier.setTools({Tool::flat(1, 6), Tool::ball(2, 4)});
    verifier.setKeepOut(KeepOut({KeepOutZone::box(24, 14, 34, 22, 6)}, 1.0));
  }
};

} // namespace

TEST_F(Clamped, AProgramThatKeepsAwayHasNoFinding)
{
  Text text;
  text.over(-5, 0).feed(-5, 0, -2);
  for (double y = 0; y <= 10; y += 2)
    text.feed(-5, y, -2).feed(35, y, -2).feed(35, y, 1).feed(-5, y, 1);
  for (double y = 10; y <= 20; y += 2)
    text.feed(-5, y, -2).feed(20, y, -2).feed(20, y, 1).feed(-5, y, 1);
  const auto result = verifier.verify(text.end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_EQ(result.keep_out_depth, 0);
  EXPECT_EQ(result.keep_out_moves, 0u);
}

TEST_F(Clamped, AFeedIntoTheMarginIsFoundWithItsLineAndDepth)
{
  Text text;
  text.over(-5, 16).feed(-5, 16, -2);
  const std::size_t line = text.lines() + 1;
  text.feed(20.3, 16, -2).feed(20.3, 16, 1).feed(-5, 16, 1);
  const auto result = verifier.verify(text.end());
  const auto* finding = find(result, "keep_out");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->line, line);
  EXPECT_NEAR(finding->worst, 0.3, 1e-6);
  EXPECT_NEAR(result.keep_out_depth, 0.3, 1e-6);
  EXPECT_EQ(result.keep_out_moves, 3u);
  EXPECT_NEAR(result.keep_out_at.x(), 20.3, 1e-6);
}

TEST_F(Clamped, AZoneBesideTheStockCountsToo)
{
  Text text;
  text.over(33, 0).feed(33, 0, -2).feed(33, 11, -2).feed(33, 0, 1);
  EXPECT_NEAR(verifier.verify(text.end()).keep_out_depth, 1.0, 1e-6);
}

TEST_F(Clamped, ARapidOverItMustClearItsTopAndTheMargin)
{
  const auto depthAt = [&](const char* rapid) {
    Text text;
    text.over(28, -5)(rapid)("G0 Y30.")("G0 Z10.");
    text.over(-5, 0).feed(-5, 0, 1);
    return verifier.verify(text.end()).keep_out_depth;
  };
  EXPECT_EQ(depthAt("G0 Z7."), 0);
  EXPECT_NEAR(depthAt("G0 Z6.4"), 0.6, 1e-6);
}

TEST_F(Clamped, ARapidThatGoesRoundItMustClearItWhereverItsAxesArrive)
{
  Text text;
  text.over(10, 16)("G0 Z1.");
  const std::size_t line = text.lines() + 1;
  text("G0 X24. Y6.")("G0 Z10."); // straight it would be 2.6 away from the clamp
  text.over(-5, 0).feed(-5, 0, 1);
  auto result = verifier.verify(text.end());
  EXPECT_EQ(result.rapids_in_stock, 0u);
  ASSERT_NE(find(result, "keep_out"), nullptr) << codes(result);
  EXPECT_EQ(result.keep_out_line, line);
  EXPECT_NEAR(result.keep_out_depth, 3.0, 1e-6); // the whole radius

  // One axis after the other it is clear, and so is a feed.
  Text apart;
  apart.over(10, 16)("G0 Z1.")("G0 Y6.")("G0 X24.")("G0 Z10.");
  apart.over(10, 16).feed(10, 16, 1).feed(24, 6, 1);
  result = verifier.verify(apart.end());
  EXPECT_EQ(find(result, "keep_out"), nullptr);
}

TEST_F(Clamped, WhatStaysUncutBecauseOfItIsCountedApart)
{
  const KeepOutZone clamp = KeepOutZone::box(24.2, 14.2, 34, 22, 6);
  const KeepOut keep_out({clamp}, 1.0);
  verifier.setKeepOut(keep_out);
  // The flat's rows go as near to the zone as they may.
  Text text;
  text.over(-5, 0).feed(-5, 0, -2);
  for (double y = 0; y <= 20; y += 0.5) {
    double end = 33;
    while (keep_out.lowest(Tool::flat(1, 6), end, y) > -2)
      end -= 0.01;
    text.feed(-5, y, -2).feed(end, y, -2).feed(end, y, 1).feed(-5, y, 1);
  }
  auto result = verifier.verify(text.end());
  EXPECT_TRUE(result.good()) << codes(result);
  // A disc reaches every place that is no nearer to the box than the margin: the box
  // bulges.
  std::size_t hidden = 0;
  for (const auto& p : *cloud)
    hidden += clamp.distance(p.x, p.y) < 1;
  EXPECT_EQ(result.kept_out_points, hidden);
  EXPECT_EQ(result.unreachable_points, result.kept_out_points);
  EXPECT_EQ(result.untouched_points, hidden);
  EXPECT_LE(result.residual.p99, 0.01); // without them
  EXPECT_LE(result.deviation.p99, 0.01);

  // Without the zone the same rows leave material that should not be there.
  verifier.setKeepOut(KeepOut());
  result = verifier.verify(text.end());
  EXPECT_EQ(result.kept_out_points, 0u);
  EXPECT_EQ(result.unreachable_points, 0u);
  EXPECT_GT(result.residual.max, 1);
}

TEST_F(Clamped, WhereTheMachineStandsIsUnknownItMustBeAboveTheZones)
{
  // The stock ends at 0, the clamp and its margin at 7.
  const auto program = [](const char* first) {
    std::istringstream in(
        std::string("G21 G17 G90 G94 G54\nT1 M6\nG43 H1\nS8000 M3\n") + first +
        "\nG0 X-5. Y0.\nG1 Z1. F600\nG0 Z10.\nM5\nM2\n");
    return readProgram(in);
  };
  EXPECT_EQ(find(verifier.verify(program("G0 Z8.")), "unknown_position"), nullptr);
  EXPECT_NE(find(verifier.verify(program("G0 Z5.")), "unknown_position"), nullptr);
  verifier.setKeepOut(KeepOut());
  EXPECT_EQ(find(verifier.verify(program("G0 Z5.")), "unknown_position"), nullptr);
}

TEST_F(Clamped, ADogLegMustNotMeetStockEither)
{
  verifier.setKeepOut(KeepOut());
  // A slot round two sides of the plate; the rapid from its one end to the other passes
  // through the air over the corner only if both axes arrive together.
  Text text;
  text.over(-5, 20).feed(-5, 20, -1).feed(15, 20, -1).feed(-5, 20, -1);
  text("G0 Z10.").over(-4, 10)("G0 Z-1.");
  const std::size_t line = text.lines() + 1;
  text("G0 X2. Y20.")("G0 Z10."); // the straight line passes beside the corner
  text.over(-5, 0).feed(-5, 0, 1);
  const auto result = verifier.verify(text.end());
  const auto* rapid = find(result, "rapid_in_stock");
  ASSERT_NE(rapid, nullptr) << codes(result);
  EXPECT_EQ(rapid->line, line);
  EXPECT_NEAR(rapid->worst, 1.0, 0.03);
}

TEST_F(Clamped, IsTheSameForAnyNumberOfThreads)
{
  Text text;
  text.over(-5, 16);
  for (int i = 0; i < 6000; ++i)
    text.feed(15 + 7 * std::sin(0.1 * i), 16 + 5 * std::cos(0.037 * i), -1.5);
  const Program program = text.end();
  verifier.setNumberOfThreads(1);
  const auto one = verifier.verify(program);
  verifier.setNumberOfThreads(5);
  const auto five = verifier.verify(program);
  EXPECT_GT(one.keep_out_depth, 1);
  EXPECT_EQ(one.keep_out_depth, five.keep_out_depth);
  EXPECT_EQ(one.keep_out_line, five.keep_out_line);
  EXPECT_EQ(one.keep_out_moves, five.keep_out_moves);
}
