// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Where a program's sections begin.
#include "reading.h"

using reading::read;

namespace {

/// "name|tool|line|move", one after the other.
std::string sections(const std::string& text)
{
  std::string out;
  for (const auto& s : read("G21 G90 G64 F100\n" + text).sections)
    out += (out.empty() ? "" : ", ") + s.name + "|" + std::to_string(s.tool) + "|" +
           std::to_string(s.line) + "|" + std::to_string(s.move);
  return out;
}

const std::string cut = "G0 X0 Y0 Z5\nG1 Z0\n";

} // namespace

TEST(Sections, BeginAtToolChangesAndAtOperations)
{
  EXPECT_EQ(sections("G0 Z5\n"), "");
  EXPECT_EQ(sections("T3 M6\n" + cut + "T4 M6\n" + cut), "|3|2|0, |4|5|2");
  EXPECT_EQ(sections("T3 M6\n" + cut + "(Operation 2: finish, all)\n" + cut),
            "|3|2|0, finish, all|3|5|2");
  EXPECT_EQ(sections("(Operation 1: a)\n" + cut + "(operation 2: b)\n" + cut),
            "a|0|2|0, b|0|5|2");
}

TEST(Sections, OfCommentAndToolChangeAreOne)
{
  EXPECT_EQ(sections("(Operation 1: rough)\nM5\nG53 G0 Z0\nT3 M6\nG43 H3\n" + cut),
            "rough|3|2|0");
  EXPECT_EQ(sections("T3 M6\n(Operation 1: rough)\n" + cut), "rough|3|2|0");
  EXPECT_EQ(sections("T3 M6\n(Operation 1: rough)\n" + cut + "T5 M6\n" + cut),
            "rough|3|2|0, |5|6|2");
  // Each begins one of its own where it is the second of its kind.
  EXPECT_EQ(sections("(Operation 1: a)\n(Operation 2: b)\nT3 M6\n" + cut),
            "a|0|2|0, b|3|3|0");
  EXPECT_EQ(sections("T3 M6\nT4 M6\n(Operation 1: a)\n" + cut), "|3|2|0, a|4|3|0");
}

TEST(Sections, OnlyACommentThatNamesAnOperationIsOne)
{
  EXPECT_EQ(sections("(OPERATION 12 - ROUGH)\n" + cut), "ROUGH|0|2|0");
  EXPECT_EQ(sections("; operation 1 : rough \n" + cut), "rough|0|2|0");
  EXPECT_EQ(sections("G0 X1 (Operation 1:)\n" + cut), "|0|2|0");
  for (const char* const other : {"(Operation: x)",
                                  "(Operations 1: x)",
                                  "(Operation one: x)",
                                  "(Operation 1)",
                                  "(The Operation 1: x)",
                                  "(Operation1: x)",
                                  "(Operation)"})
    EXPECT_EQ(sections(other + ("\n" + cut)), "") << other;
}

TEST(Sections, GoOnInTheNextFile)
{
  auto program = read("G21 G90 F100\n(Operation 1: a)\n" + cut + "M30\n");
  program.append(read("G21 G90 F100\n(Operation 2: b)\n" + cut + "M30\n"), "b.nc");
  ASSERT_EQ(program.sections.size(), 2u);
  EXPECT_EQ(program.sections[1].move, 2u);
  EXPECT_EQ(program.sections[1].line, program.sections[0].line + 5);
  EXPECT_EQ(program.moves.size(), 4u);
}
