// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Each check has a program that it alone refuses, and one near it that passes.
#include "plate.h"

#include <moves.h>

#include <fstream>

using namespace verify_test;

namespace {

/// A block 10 high with its part under the slot that is milled, far below.
struct OnADeepBlock : ::testing::Test {
  const Rectangle area{0, 8, 40, 12};
  const Cloud::Ptr cloud = surface(area, 1.0, [](double, double) { return -10; });
  ProgramVerifier verifier;

  OnADeepBlock()
  {
    verifier.setPart(indexOf(*cloud));
    verifier.setStock({{0, 0, -10}, {40, 20, 0}});
  }
  /// A slot across the block, 2 mm at a time.
  static Text slot(double depth, Text text = Text())
  {
    for (double z = -2; z >= -depth; z -= 2)
      text.over(-20, 10).feed(-20, 10, z).feed(60, 10, z);
    return text;
  }
};
using Checks = OnAPlate;
using Bodies = OnADeepBlock;

} // namespace

TEST_F(Checks, AFlatEndMustNotBeSunkStraight)
{
  const auto sunk = [&](const Text& into) {
    return verifier.verify(rows(-2, 4, into).end());
  };
  const auto plunge = sunk(Text().over(15, 10).feed(15, 10, 0.5).feed(15, 10, -1));
  ASSERT_EQ(codes(plunge), "plunge ");
  EXPECT_NEAR(plunge.findings[0].worst, 1, 1e-5);
  EXPECT_EQ(plunge.findings[0].line, 9u);
  EXPECT_EQ(plunge.findings[0].tool, 1);
  EXPECT_FALSE(plunge.good());

  // A ramp of slope 0.1 presses the end's middle, 3 mm wide, by 0.3.
  EXPECT_EQ(codes(sunk(Text().over(15, 10).feed(15, 10, -0.28))), "");
  const auto pressed = sunk(Text().over(15, 10).feed(15, 10, -0.32));
  EXPECT_EQ(codes(pressed), "pressed_in ");
  EXPECT_TRUE(pressed.good());
  // A tenth of the diameter, 6 mm, is too much.
  EXPECT_EQ(codes(sunk(Text().over(15, 10).feed(15, 10, -0.58))), "pressed_in ");
  EXPECT_EQ(codes(sunk(Text().over(15, 10).feed(15, 10, -0.62))), "plunge ");

  Text pecks;
  pecks.over(15, 10);
  for (double z = 0; z >= -1; z -= 0.05)
    pecks.feed(15, 10, z);
  EXPECT_EQ(codes(sunk(pecks)), "plunge ");
  EXPECT_EQ(codes(sunk(Text().over(15, 10).feed(15, 10, 0.1).feed(16, 10, -1.9))),
            "plunge ");
  verifier.setRampLimit(70);
  EXPECT_EQ(codes(sunk(Text().over(15, 10).feed(15, 10, 0.1).feed(16, 10, -1.9))), "");
}

TEST_F(Checks, RampsHelicesSkinsAndAirAreNoPlunges)
{
  Text ramp, zigzag, helix, skin;
  ramp.over(5, 10).feed(5, 10, 0).feed(24, 10, -1);
  zigzag.over(10, 10);
  for (int i = 0; i <= 20; ++i)
    zigzag.feed(i % 2 ? 16 : 10, 10, -0.1 * i);
  helix.over(17, 10);
  for (int i = 0; i <= 200; ++i)
    helix.feed(15 + 2 * std::cos(0.2 * i), 10 + 2 * std::sin(0.2 * i), -0.01 * i);
  skin.over(15, 10).feed(15, 10, -0.05);
  for (const auto* text : {&ramp, &zigzag, &helix, &skin}) {
    const auto result = verifier.verify(rows(-2, 4, *text).end());
    EXPECT_EQ(codes(result), "");
  }
  // Where the plate is milled already, and beside the stock.
  EXPECT_EQ(codes(verifier.verify(rows(-2).over(15, 10).feed(15, 10, -2).end())), "");
}

TEST_F(Checks, ABallMayPlunge)
{
  Text text(2);
  text.over(15, 10).feed(15, 10, 0.5).feed(15, 10, -1);
  text("G0 Z10.")("T1 M6")("G43 H1")("S8000 M3")("G0 Z10.");
  EXPECT_EQ(codes(verifier.verify(rows(-2, 4, text).end())), "");
}

TEST_F(Checks, ALayerThickerThanTheFlutesAreLong)
{
  Tool tool = Tool::flat(1, 6);
  tool.flute_length = 1.5;
  verifier.setTools({tool});
  const auto result = verifier.verify(rows(-2).end());
  ASSERT_EQ(codes(result), "flute_length ");
  EXPECT_NEAR(result.findings[0].worst, 2, 1e-5);
  EXPECT_GT(result.findings[0].line, 7u);
  EXPECT_EQ(codes(verifier.verify(rows(-2, 4, rows(-1)).end())), "");
}

TEST_F(Checks, ALayerThickerThanTheLimitIsAWarning)
{
  verifier.setAxialLimit(1, 1.9);
  verifier.setAxialLimit(2, 0.1);
  const auto result = verifier.verify(rows(-2).end());
  ASSERT_EQ(codes(result), "axial_depth ");
  EXPECT_EQ(result.findings[0].severity, Severity::Warning);
  EXPECT_NEAR(result.findings[0].worst, 2, 1e-5);
  EXPECT_EQ(result.findings[0].limit, 1.9);
  EXPECT_NE(result.findings[0].text.find("2.000 mm, limit 1.9 mm"), std::string::npos)
      << result.findings[0].text;
  EXPECT_TRUE(result.good());
  EXPECT_EQ(codes(verifier.verify(rows(-2, 4, rows(-1)).end())), "");
}

TEST_F(Bodies, AShankThatIsThickerThanTheCutterMustStayOutOfTheSlot)
{
  Tool tool = Tool::flat(1, 6);
  tool.flute_length = 4;
  tool.shank_diameter = 10;
  verifier.setTools({tool});
  EXPECT_EQ(codes(verifier.verify(slot(4).end())), ""); // it touches the top
  const auto result = verifier.verify(slot(6).end());
  ASSERT_EQ(codes(result), "shank ");
  EXPECT_NEAR(result.findings[0].worst, 2 - 0.02, 1e-4); // less the tolerance
  EXPECT_EQ(result.findings[0].tool, 1);
  // So must it on rapids.
  const auto rapid = verifier.verify(
      slot(4, Text())("G0 Z10.")("G0 X20. Y10.")("G0 Z-4.")("G0 Z10.").end());
  EXPECT_EQ(codes(rapid), "");
  tool.flute_length = 3;
  verifier.setTools({tool});
  EXPECT_EQ(
      codes(verifier.verify(slot(2)("G0 Z10.")("G0 X20. Y10.")("G0 Z-1.9").end())), "");
  // A slim shank goes where the flutes have been.
  tool.shank_diameter = 6;
  verifier.setTools({tool});
  EXPECT_EQ(codes(verifier.verify(slot(10).end())), "");
}

TEST_F(Bodies, AHolderMustStayAboveTheStock)
{
  Tool tool = Tool::flat(1, 6);
  tool.stick_out = 5;
  tool.holder_diameter = 30;
  verifier.setTools({tool});
  EXPECT_EQ(codes(verifier.verify(slot(4).end())), "");
  const auto result = verifier.verify(slot(6).end());
  ASSERT_EQ(codes(result), "holder ");
  EXPECT_NEAR(result.findings[0].worst, 1 - 0.02, 1e-4);
  for (const unsigned threads : {1u, 4u}) {
    verifier.setNumberOfThreads(threads);
    const auto again = verifier.verify(slot(6).end());
    EXPECT_EQ(again.findings[0].worst, result.findings[0].worst);
    EXPECT_EQ(again.findings[0].line, result.findings[0].line);
    EXPECT_EQ(again.findings[0].count, result.findings[0].count);
  }
}

TEST_F(Bodies, AHolderMustStayOutOfKeepOutZones)
{
  Tool tool = Tool::flat(1, 6);
  tool.stick_out = 12;
  tool.holder_diameter = 30;
  verifier.setTools({tool});
  // A clamp beside the block: the cutter passes it, the holder is wider.
  const KeepOutZone clamp = KeepOutZone::cylinder(20, -4, 2, 9);
  verifier.setKeepOut(KeepOut({clamp}, 0.5));
  Text high = slot(2); // holder at 10
  for (auto text : {high.over(-20, 25)})
    EXPECT_EQ(codes(verifier.verify(text.end("G0 Z12.\nM2\n"))), "");
  const auto result = verifier.verify(slot(4).end("G0 Z12.\nM2\n")); // holder at 8
  EXPECT_EQ(codes(result), "keep_out ");
}

TEST(BodiesAtPoints, PointsThatStickOutOfTheStockCount)
{
  Cloud cloud;
  cloud.push_back(pcl::PointXYZ(0, 0, 0));
  cloud.push_back(pcl::PointXYZ(10, 8, 7));
  const auto part = indexOf(cloud);
  Tool tool = Tool::ball(4, 6);
  tool.stick_out = 5;
  tool.holder_diameter = 20;
  const auto worstAt = [&](double z) {
    pointmill::Findings findings;
    judgeBodies(*part, {{{0, 0, z}, {20, 0, z}, &tool, 7, false}}, 0.02, 1, findings);
    const auto list = findings.list();
    return list.empty() ? 0.0 : list.front().worst;
  };
  EXPECT_NEAR(worstAt(1), 1, 1e-6);  // the holder's face at 6
  EXPECT_NEAR(worstAt(-3), 2, 1e-6); // 2 inside from the side
  EXPECT_EQ(worstAt(1.99), 0);
}

TEST(BodiesAtPoints, ARapidThatBendsMeetsPointsBesideItsLine)
{
  Cloud cloud;
  cloud.push_back(pcl::PointXYZ(0, 0, -5));
  cloud.push_back(pcl::PointXYZ(18, 2, 3)); // a needle, thinner than any cell
  const auto part = indexOf(cloud);
  const Tool tool = Tool::flat(1, 4);
  const auto codesOf = [&](const Eigen::Vector3d& to, bool rapid) {
    pointmill::Findings findings;
    judgeBends(*part, {{{0, 0, 1}, to, &tool, 7, rapid}}, 0.02, 1, findings);
    const auto list = findings.list();
    return list.empty() ? std::string() : list.front().code;
  };
  EXPECT_EQ(codesOf({20, 20, 1}, true), "rapid_in_part");
  EXPECT_EQ(codesOf({20, 20, 1}, false), ""); // a feed move is straight
  EXPECT_EQ(codesOf({0, 20, 1}, true), "");   // so is a rapid along one axis
  EXPECT_EQ(codesOf({15, 20, 1}, true), "");  // 1 mm beside it
  Tool held = tool;
  held.number = 2;
  held.stick_out = 1;
  held.holder_diameter = 8;
  const std::vector<SweptMove> beside{{{0, 0, 1}, {15, 20, 1}, &held, 7, true}};
  pointmill::Findings findings;
  judgeBends(*part, beside, 0.02, 1, findings);
  ASSERT_EQ(findings.list().size(), 1u);
  EXPECT_EQ(findings.list()[0].code, "holder"); // it reaches 4 mm far, from 2 upwards
  EXPECT_NEAR(findings.list()[0].worst, 1, 1e-6);
}

TEST_F(Checks, WithoutTheToolsLengthZMeansNothingInRapidsNeither)
{
  // The spindle's nose goes to 5, and the tool into the part.
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG49\nG0 Z5.\nM2\n"))),
            "length_offset ");
  // Without H other controls take the length of the tool before.
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG43\nG0 Z15.\nM2\n"))),
            "length_offset ");
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG49\nG53 G0 Z0.\nM2\n"))), "");
}

TEST_F(Checks, AMachineHeightFarBelowTheTopMayBeInThePart)
{
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG53 G0 Z-150.\nM2\n"))),
            "unknown_position unsafe_end ");
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG30\nM2\n"))),
            "unknown_position unsafe_end ");
  EXPECT_EQ(codes(verifier.verify(rows(-2).end("G0 Z10.\nG53 G0 Z-5.\nM2\n"))), "");
}

TEST_F(Checks, WhatAWholeProgramWouldNotLeaveIsAWarning)
{
  verifier.setResidualLimit(1);
  const auto whole = verifier.verify(rows(-2).end());
  verifier.setExpectedResidual(whole.residual.p90);
  EXPECT_EQ(codes(verifier.verify(rows(-2).end())), "");
  EXPECT_EQ(codes(verifier.verify(rows(-1.9).end())), "leaves_more ");
}

TEST_F(Checks, AProgramEndsAndChangesToolsHighUp)
{
  const auto end = verifier.verify(rows(-2).end("G0 Z-1.\nM2\n"));
  ASSERT_EQ(codes(end), "unsafe_end ");
  EXPECT_NEAR(end.findings[0].worst, 1, 1e-9);
  Text low = rows(-2), high = rows(-2);
  const std::size_t line = low.lines();
  low("T2 M6")("G43 H2");
  high("G53 G0 Z0.")("T2 M6")("G43 H2");
  const auto change = verifier.verify(low.end());
  ASSERT_EQ(codes(change), "unsafe_tool_change ");
  EXPECT_NEAR(change.findings[0].worst, 2, 1e-9);
  EXPECT_EQ(change.findings[0].line, line);
  EXPECT_EQ(codes(verifier.verify(high.end())), "");
}

TEST_F(Checks, ARapidBelowTheStockIsOne)
{
  Text text;
  text.over(-5, 10)("G0 Z-3.5");
  EXPECT_EQ(codes(verifier.verify(rows(-2, 4, text).end())), "below_stock ");
}

TEST_F(Checks, TheMachinesLimits)
{
  const Program program = rows(-2).end();
  Machine machine;
  machine.travel = Stock{{-6, -1, -5}, {36, 21, 11}};
  machine.max_feed = 600;
  machine.min_spindle = 1000;
  machine.max_spindle = 8000;
  verifier.setMachine(machine);
  EXPECT_EQ(codes(verifier.verify(program)), "");
  machine.travel->max.x() = 34;
  verifier.setMachine(machine);
  const auto travel = verifier.verify(program);
  ASSERT_EQ(codes(travel), "outside_travel ");
  EXPECT_NEAR(travel.findings[0].worst, 1, 1e-9);
  EXPECT_GT(travel.findings[0].count, 2u);
  machine.travel.reset();
  machine.max_feed = 599;
  verifier.setMachine(machine);
  EXPECT_EQ(codes(verifier.verify(program)), "feed_limit ");
  machine.max_feed = 0;
  machine.max_spindle = 7900;
  verifier.setMachine(machine);
  const auto fast = verifier.verify(program);
  ASSERT_EQ(codes(fast), "spindle_limit ");
  EXPECT_NEAR(fast.findings[0].worst, 100, 1e-9);
  machine.max_spindle = 0;
  machine.min_spindle = 9000;
  verifier.setMachine(machine);
  EXPECT_EQ(codes(verifier.verify(program)), "spindle_limit ");
  machine.rapid_rate = -1;
  verifier.setMachine(machine);
  EXPECT_THROW(verifier.verify(program), ParameterError);
}

TEST_F(Checks, FeedsAndSpeedsThatMakeNoSense)
{
  const Program good = rows(-2).end();
  const auto with = [&](double feed, double spindle) {
    Program program = good;
    for (auto& m : program.moves)
      if (!m.rapid) {
        m.feed = feed;
        m.spindle = spindle;
      }
    return codes(verifier.verify(program));
  };
  EXPECT_EQ(with(600, 8000), "");
  EXPECT_EQ(with(0, 8000), "feed ");
  EXPECT_EQ(with(2e5, 2e5), "feed ");
  EXPECT_EQ(with(600, 0), "spindle ");
  EXPECT_EQ(with(600, 1e6), "spindle ");
  EXPECT_EQ(with(15240, 8000), "chip_load "); // as if inches were millimetres
  EXPECT_EQ(with(600, 400), "chip_load ");
  EXPECT_EQ(with(600, 8), "feed "); // 37 mm a tooth breaks the tool
  EXPECT_EQ(with(0.5, 8000), "feed ");
  Program changed = good;
  changed.moves[changed.moves.size() / 2].spindle = 7000;
  const auto result = verifier.verify(changed);
  ASSERT_EQ(codes(result), "spindle_change ");
  EXPECT_NEAR(result.findings[0].worst, 1000, 1e-9);
  EXPECT_EQ(result.findings[0].count, 2u);
  EXPECT_TRUE(result.good());
}

TEST_F(Checks, AnOperationThatCutsNothingIsAWarning)
{
  Text text = rows(-2);
  text("G0 Z10.")("T2 M6")("G43 H2")("S8000 M3")("G0 Z10.");
  text.over(5, 5).feed(5, 5, -2).feed(25, 5, -2);
  const auto result = verifier.verify(text.end());
  ASSERT_EQ(codes(result), "cuts_nothing ");
  EXPECT_EQ(result.findings[0].tool, 2);
  EXPECT_TRUE(result.good());
}

TEST_F(Checks, FindingsComeAsTheirTableHasThem)
{
  verifier.setAxialLimit(1, 1);
  Text text;
  text.over(15, 10).feed(15, 10, 0.5).feed(15, 10, -1);
  const auto result = verifier.verify(rows(-2.5, 4, text).end("G0 Z-1.\n"));
  EXPECT_EQ(codes(result), "gouge plunge unsafe_end not_ended axial_depth ");
  EXPECT_FALSE(result.good());
  for (const auto& f : result.findings)
    EXPECT_FALSE(f.text.empty());
  EXPECT_EQ(result.findings[0].text,
            "points of the part get too deep into a tool: 0.500 mm, " +
                std::to_string(cloud->size()) + " points, T1");
}

TEST(FindingCodes, StandOnTheStagesPage)
{
  std::ifstream in(std::string(POINTMILL_DOC) + "/stages/program_verifier.md");
  std::ostringstream page;
  page << in.rdbuf();
  std::set<std::string> seen;
  for (const auto& code : findingCodes()) {
    EXPECT_TRUE(seen.insert(code.code).second) << code.code;
    const std::string row = "| `" + code.code + "` | " +
                            (code.severity == Severity::Error ? "error" : "warning") +
                            " | " + (code.unit.empty() ? "-" : code.unit) + " | " +
                            code.meaning + " |";
    EXPECT_NE(page.str().find(row), std::string::npos) << row;
  }
}
