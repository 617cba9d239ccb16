// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What each section of a program does.
#include "plate.h"

#include <moves.h>

using namespace verify_test;

namespace {
using Sections = OnAPlate;
}

TEST_F(Sections, WithoutNamesThereIsOneForEachTool)
{
  Text text = rows(-1);
  text("G0 Z10.")("T2 M6")("G43 H2")("S8000 M3")("G0 Z10.");
  text.over(-5, 10).feed(-5, 10, -1.5).feed(35, 10, -1.5);
  const auto result = verifier.verify(text.end());
  ASSERT_EQ(result.sections.size(), 2u);
  const auto &rough = result.sections[0], &fine = result.sections[1];
  EXPECT_EQ(rough.tool, 1);
  EXPECT_EQ(fine.tool, 2);
  EXPECT_NEAR(rough.volume, 30 * 20 * 1, 1e-3);
  EXPECT_NEAR(rough.axial_depth, 1, 1e-5);
  // A groove half a millimetre deep: a segment of the ball's circle.
  const double segment = 4 * std::acos(0.75) - 1.5 * std::sqrt(4 - 1.5 * 1.5);
  EXPECT_NEAR(fine.volume, 30 * segment, 0.02 * 30 * segment);
  EXPECT_LE(fine.axial_depth, 0.5); // the middle of a round layer is not all of it
  EXPECT_GE(fine.axial_depth, 0.3);
  EXPECT_NEAR(fine.feed_length, 11.5 + 40, 1e-9);
  EXPECT_EQ(fine.feed_moves, 2u);
  EXPECT_EQ(rough.feed_moves + fine.feed_moves, result.feed_moves);
  EXPECT_EQ(rough.rapid_moves + fine.rapid_moves, result.rapid_moves);
}

TEST_F(Sections, AreThoseThatTheProgramNames)
{
  Program program = rows(-2, 4, rows(-1)).end();
  std::size_t second = 0; // the first move of the second pass
  for (std::size_t k = 0; k < program.moves.size(); ++k)
    if (program.moves[k].rapid && program.moves[k].to.z() > 5)
      second = second == 0 && k > 5 ? k : second;
  program.sections = {
      {"above", 1, 1, 0}, {"below", 1, 40, second}, {"no", 1, 99, 1u << 30}};
  for (const unsigned threads : {1u, 3u}) {
    verifier.setNumberOfThreads(threads);
    const auto result = verifier.verify(program);
    ASSERT_EQ(result.sections.size(), 2u);
    EXPECT_EQ(result.sections[0].name, "above");
    EXPECT_EQ(result.sections[1].name, "below");
    EXPECT_EQ(result.sections[1].line, 40u);
    EXPECT_NEAR(result.sections[0].volume, 600, 1e-3);
    EXPECT_NEAR(result.sections[1].volume, 600, 1e-3);
  }
}

TEST(SectionsOf, ASectionWithTwoToolsIsParted)
{
  Program program;
  const auto add = [&](int tool, bool rapid) {
    ProgramMove m;
    m.from = m.to = Eigen::Vector3d::Zero();
    m.tool = tool;
    m.rapid = rapid;
    m.line = program.moves.size() + 1;
    program.moves.push_back(m);
  };
  for (const auto& [tool, rapid] : std::vector<std::pair<int, bool>>{{0, true},
                                                                     {1, true},
                                                                     {1, false},
                                                                     {1, true},
                                                                     {2, true},
                                                                     {2, false},
                                                                     {2, true}})
    add(tool, rapid);
  program.sections = {{"all", 1, 1, 0}};
  const auto sections = sectionsOf(program);
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].tool, 1);
  EXPECT_EQ(sections[1].name, "all");
  EXPECT_EQ(sections[1].tool, 2);
  EXPECT_EQ(sections[1].move, 4u);
  EXPECT_EQ(sections[1].line, 5u);
  // A comment before the tool change begins the section, and does not part it.
  program.sections = {{"one", 1, 1, 0}, {"two", 2, 4, 3}};
  ASSERT_EQ(sectionsOf(program).size(), 2u);
  EXPECT_EQ(sectionsOf(program)[1].tool, 2);
  EXPECT_EQ(sectionsOf(program)[1].move, 3u);
}
