// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What must not be in a program is found, and nothing else.
#include "plate.h"

using namespace verify_test;

using Findings = OnAPlate;

TEST_F(Findings, ACleanProgramHasNone)
{
  const auto result = verifier.verify(rows(-2).end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_NEAR(result.gouge, 0, 1e-6);
  EXPECT_EQ(result.gouged_points, 0u);
  EXPECT_NEAR(result.residual.max, 0, 1e-5);
  EXPECT_NEAR(result.deviation.max, 0, 1e-5);
  EXPECT_EQ(result.points, cloud->size());
  EXPECT_EQ(result.untouched_points, 0u);
  EXPECT_EQ(result.unreachable_points, 0u);
  EXPECT_EQ(result.rapids_in_stock, 0u);
  EXPECT_NEAR(result.axial_depth.at(1), 2, 1e-5);
  EXPECT_NEAR(result.lowest_tip.at(1), -2, 1e-9);
}

TEST_F(Findings, ACutTooDeepIsAGougeOfThatDepth)
{
  for (const double deep : {0.2, 0.03}) {
    const auto result = verifier.verify(rows(-2 - deep).end());
    const auto* gouge = find(result, "gouge");
    ASSERT_NE(gouge, nullptr) << deep;
    EXPECT_EQ(result.findings.size(), 1u) << codes(result);
    EXPECT_NEAR(gouge->worst, deep, 1e-5);
    EXPECT_NEAR(result.gouge, deep, 1e-5);
    EXPECT_EQ(result.gouged_points, cloud->size());
    EXPECT_GT(gouge->line, 7u);
  }
}

TEST_F(Findings, ACutTooDeepWithinTheToleranceIsNone)
{
  const auto result = verifier.verify(rows(-2.015).end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_NEAR(result.gouge, 0.015, 1e-5);
}

TEST_F(Findings, AGougeNamesItsLineAndPlace)
{
  Text text = rows(-2);
  text.over(15, 10).feed(15, 10, -1.9);
  const std::size_t line = text.lines() + 1;
  text.feed(15, 10, -2.5).feed(15, 10, -1);
  const auto result = verifier.verify(text.end());
  const auto* gouge = find(result, "gouge");
  ASSERT_NE(gouge, nullptr);
  EXPECT_EQ(gouge->line, line);
  EXPECT_LE((gouge->place.head<2>() - Eigen::Vector2d(15, 10)).norm(), 3);
  EXPECT_NEAR(gouge->worst, 0.5, 1e-5);
  std::size_t under = 0;
  for (const auto& p : *cloud)
    under += std::hypot(p.x - 15, p.y - 10) < 3 - 0.02;
  EXPECT_NEAR(double(result.gouged_points), double(under), 4);
}

TEST_F(Findings, ARapidThroughTheStockIsOneWithItsLine)
{
  Text text;
  text.over(-5, 10)("G0 Z-1.");
  const std::size_t line = text.lines() + 1;
  text("G0 X35.")("G0 Z10.");
  // Then the plate is milled as it should be.
  text.over(-5, 0).feed(-5, 0, -2);
  for (double y = 0; y <= 20; y += 4)
    text.feed(-5, y, -2).feed(35, y, -2).feed(35, y, 1).feed(-5, y, 1);
  const auto result = verifier.verify(text.end());
  const auto* rapid = find(result, "rapid_in_stock");
  ASSERT_NE(rapid, nullptr);
  EXPECT_EQ(result.findings.size(), 1u) << codes(result);
  EXPECT_EQ(rapid->line, line);
  EXPECT_EQ(result.rapids_in_stock, 1u);
  EXPECT_NEAR(result.rapid_depth, 1, 0.03);
}

TEST_F(Findings, ARapidDownIntoTheStockIsOne)
{
  Text text = rows(-2);
  Text early;
  early.over(15, 10)("G0 Z-1.").feed(15, 10, -2);
  EXPECT_NE(find(verifier.verify(early.end()), "rapid_in_stock"), nullptr);
  // The same rapid where the stock is gone is none.
  text.over(15, 10)("G0 Z-1.").feed(15, 10, -2);
  EXPECT_TRUE(verifier.verify(text.end()).good());
}

TEST_F(Findings, ARapidOverTheStockTouchesNothing)
{
  Text text;
  text.over(-5, 10)("G0 Z0.")("G0 X35.")("G0 Z10.");
  text.over(-5, 0).feed(-5, 0, -2);
  EXPECT_EQ(find(verifier.verify(text.end()), "rapid_in_stock"), nullptr);
}

TEST_F(Findings, AFeedMoveWithoutSpindleIsOne)
{
  Text text;
  text("M5").over(-5, 0).feed(-5, 0, -2);
  const auto result = verifier.verify(text.end());
  const auto* spindle = find(result, "spindle");
  ASSERT_NE(spindle, nullptr);
  EXPECT_EQ(spindle->line, text.lines());
  Text backwards;
  backwards("S5000 M4").over(-5, 0).feed(-5, 0, -2);
  EXPECT_NE(find(verifier.verify(backwards.end()), "spindle"), nullptr);
}

TEST_F(Findings, AnUnknownToolIsOne)
{
  Text text(7);
  text.over(-5, 0).feed(-5, 0, -2);
  const auto result = verifier.verify(text.end());
  const auto* tool = find(result, "unknown_tool");
  ASSERT_NE(tool, nullptr);
  EXPECT_NE(tool->text.find("7"), std::string::npos);
}

TEST_F(Findings, AProgramWithoutEndIsOne)
{
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\n"))), "not_ended ");
  EXPECT_TRUE(verifier.verify(rows(-2).end("G0 Z10.\nM30\n")).good());
}

TEST_F(Findings, AProgramWithoutFeedMovesCutsNothing)
{
  Text text;
  text.over(5, 5).over(20, 10);
  EXPECT_EQ(codes(verifier.verify(text.end())), "residual empty ");
  Program nothing;
  nothing.ended = true;
  const auto result = verifier.verify(nothing);
  EXPECT_EQ(codes(result), "residual empty ");
  EXPECT_EQ(result.untouchedShare(), 1);
}

TEST_F(Findings, AProgramThatLeavesTooMuchIsOne)
{
  const auto result = verifier.verify(rows(-1.7).end());
  const auto* residual = find(result, "residual");
  ASSERT_NE(residual, nullptr);
  EXPECT_NEAR(residual->worst, 0.3, 1e-4);
  verifier.setResidualLimit(0.31);
  EXPECT_TRUE(verifier.verify(rows(-1.7).end()).good());
}

TEST_F(Findings, AProgramThatMillsBesideThePartLeavesTooMuch)
{
  // All of the points keep all of the material.
  Text text;
  text.over(-50, 0).feed(-50, 0, -2).feed(-50, 20, -2);
  const auto result = verifier.verify(text.end());
  EXPECT_EQ(result.untouched_points, cloud->size());
  EXPECT_FALSE(result.good()) << "nothing of the part was milled";
}

TEST_F(Findings, AProgramThatMillsACornerOnlyLeavesTooMuch)
{
  // Over half of the points no tool passes at all.
  Text text;
  text.over(-5, 0).feed(-5, 0, -2).feed(5, 0, -2);
  const auto result = verifier.verify(text.end());
  EXPECT_GT(result.untouched_points, 9 * cloud->size() / 10);
  EXPECT_FALSE(result.good());
}

TEST_F(Findings, BesideAWallTheGougeIsTheOverlapNotTheHeight)
{
  // A wall 20 high along y = 10; a flat of radius 3 runs and plunges 0.05 too near.
  Cloud::Ptr wall = surface({0, 0, 30, 9.5}, 0.5, [](double, double) { return -20; });
  for (double z = -20; z <= 0; z += 0.5)
    for (double x = 0; x <= 30; x += 0.5)
      wall->push_back(pcl::PointXYZ(float(x), 10.f, float(z)));
  verifier.setPart(indexOf(*wall));
  verifier.setStock({{0, 0, -21}, {30, 12, 0}});
  verifier.setResidualLimit(100);
  for (const double overlap : {0.05, 0.02, 0.01}) {
    verifier.setTolerance(0.015);
    Text plunge, along;
    plunge.over(15, 10 - 3 + overlap).feed(15, 10 - 3 + overlap, -20);
    along.over(-5, 10 - 3 + overlap)
        .feed(-5, 10 - 3 + overlap, -20)
        .feed(35, 10 - 3 + overlap, -20);
    for (const auto* text : {&plunge, &along}) {
      const auto result = verifier.verify(text->end());
      EXPECT_NEAR(result.gouge, overlap, 1e-5) << overlap;
      EXPECT_EQ(find(result, "gouge") != nullptr, overlap > 0.015) << overlap;
    }
  }
}

TEST_F(Findings, AMoveSidewaysAfterAToolChangeIsOne)
{
  // Z is not known, or only that it is the machine's top.
  std::istringstream low("G21 G90 G94\nT1 M6\nG43 H1\nS8000 M3\nG0 X5. Y5.\n"
                         "G0 Z1.\nG1 X6. Z-1. F100\nM2\n");
  EXPECT_NE(find(verifier.verify(readProgram(low)), "unknown_position"), nullptr);
  std::istringstream high("G21 G90 G94\nT1 M6\nG43 H1\nS8000 M3\nG53 G0 Z0.\n"
                          "G0 X5. Y5.\nG0 Z1.\nG1 X6. Z-1. F100\nM2\n");
  EXPECT_EQ(find(verifier.verify(readProgram(high)), "unknown_position"), nullptr);
}

TEST_F(Findings, SettingsThatMakeNoSenseAreRefused)
{
  const Program program = rows(-2).end();
  ProgramVerifier without;
  without.setStock({{0, 0, -3}, {30, 20, 0}});
  EXPECT_THROW(without.verify(program), DataError);
  auto bad = verifier;
  bad.setTolerance(0);
  EXPECT_THROW(bad.verify(program), ParameterError);
  bad = verifier;
  bad.setTolerance(std::nan(""));
  EXPECT_THROW(bad.verify(program), ParameterError);
  bad = verifier;
  bad.setCellSize(0);
  EXPECT_THROW(bad.verify(program), ParameterError);
  bad = verifier;
  bad.setStock({{0, 0, 0}, {30, 20, 0}});
  EXPECT_THROW(bad.verify(program), ParameterError);
  bad = verifier;
  bad.setTools({Tool::flat(1, -6)});
  EXPECT_THROW(bad.verify(program), ParameterError);
}

TEST_F(Findings, TwoToolsOfOneNumberAreRefused)
{
  verifier.setTools({Tool::flat(1, 6), Tool::ball(1, 4)});
  EXPECT_THROW(verifier.verify(rows(-2).end()), ParameterError);
}

TEST_F(Findings, ACutIntoAProtectedPlaceIsOne)
{
  Cloud bridge;
  bridge.push_back(pcl::PointXYZ(15, 10, -1.5f)); // over a gap, higher than the plate
  verifier.setProtected(indexOf(bridge));
  const auto result = verifier.verify(rows(-2).end());
  const auto* gap = find(result, "gap");
  ASSERT_NE(gap, nullptr) << codes(result);
  EXPECT_NEAR(gap->worst, 0.5, 1e-5);
  EXPECT_EQ(result.gouged_points, 0u);
}

TEST_F(Findings, FeedWithoutTheToolsLengthIsOne)
{
  Text text;
  text("G49")("G53 G0 Z0.").over(-5, 0).feed(-5, 0, -2);
  EXPECT_NE(find(verifier.verify(text.end()), "length_offset"), nullptr);
}

TEST_F(Findings, MoreRoundingOfCornersThanAllowedIsOne)
{
  verifier.setBlendLimit(0.01);
  const auto with = [&](const char* mode) {
    Text text;
    text(mode).over(-5, 0).feed(-5, 0, -2).feed(35, 0, -2);
    return find(verifier.verify(text.end()), "blend") != nullptr;
  };
  EXPECT_TRUE(with("G64"));
  EXPECT_TRUE(with("G64 P0.05"));
  EXPECT_TRUE(with("(no word on it)"));
  EXPECT_FALSE(with("G64 P0.01 Q0."));
  EXPECT_FALSE(with("G61"));
}

TEST_F(Findings, FeedBelowTheStockIsOne)
{
  Text text;
  text.over(-5, 0).feed(-5, 0, -2).feed(-5, 0, -3.5);
  const auto result = verifier.verify(text.end());
  const auto* below = find(result, "below_stock");
  ASSERT_NE(below, nullptr) << codes(result);
  EXPECT_EQ(below->line, text.lines());
}

TEST_F(Findings, WhatLiesUnderTheFloorIsNotLeftOver)
{
  EXPECT_NE(find(verifier.verify(rows(-1.5).end()), "residual"), nullptr);
  verifier.setFloor(-1.5);
  const auto result = verifier.verify(rows(-1.5).end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_NEAR(result.residual.max, 0, 1e-5);
}
