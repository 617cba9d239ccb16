// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Heidenhain's conversational programs.
#include "reading.h"

#include <vector>

using pointmill::ProgramForm;
using reading::place;
using reading::way;

namespace {

pointmill::Program read(const std::string& text)
{
  return reading::read(text, ProgramForm::Klartext);
}

/// Numbers blocks and puts BEGIN PGM and END PGM about them.
std::string numbered(const std::vector<std::string>& blocks,
                     const std::string& unit = "MM")
{
  std::string text = "0 BEGIN PGM A " + unit + "\n";
  int number = 1;
  for (const auto& block : blocks)
    text += std::to_string(number++) + " " + block + "\n";
  return text + std::to_string(number) + " END PGM A " + unit + "\n";
}

/// Behind a known position with a feed: in line 4.
std::string refusal(const std::string& block)
{
  return reading::refusal(
      numbered({"TOOL CALL 1 Z S1000", "L X+0 Y+0 Z+5 R0 FMAX M3", block}),
      ProgramForm::Klartext);
}

/// The moves of @p blocks from (10, 0, 5), tool 1, F 100.
pointmill::Program from(std::vector<std::string> blocks)
{
  blocks.insert(blocks.begin(),
                {"TOOL CALL 1 Z S1000 F100", "L X+10 Y+0 Z+5 R0 FMAX M3"});
  return read(numbered(blocks));
}

double length(const pointmill::Program& program)
{
  double sum = 0;
  for (const auto& m : program.moves)
    if (!m.rapid)
      sum += (m.to - m.from).norm();
  return sum;
}

const double pi = std::acos(-1.0);

} // namespace

TEST(Klartext, AProgramWithTwoTools)
{
  const auto p = read("0 BEGIN PGM PART MM\n"
                      "1 BLK FORM 0.1 Z X-20 Y-20 Z-10\n"
                      "2 BLK FORM 0.2 X+20 Y+20 Z+0\n"
                      "3 ; Operation 1: rough\n"
                      "4 CYCL DEF 32.0 TOLERANCE\n"
                      "5 CYCL DEF 32.1 T+0.013\n"
                      "6 CYCL DEF 247 DATUM SETTING ~\n"
                      "  Q339=+1 ;DATUM NUMBER\n"
                      "7 L Z+0 R0 FMAX M91\n"
                      "8 TOOL CALL 1 Z S12000\n"
                      "9 TOOL DEF 2\n"
                      "10 L X+0 Y+0 R0 FMAX M3 ; to the part\n"
                      "11 L Z+5 R0 FMAX M8\n"
                      "12 L Z-1 R0 F300\n"
                      "13 L IX+10\n"
                      "14 CC X+15 Y+0\n"
                      "15 C X+20 Y+0 DR-\n"
                      "16 L Z+5 R0 FMAX\n"
                      "17 M5\n"
                      "18 L Z+0 R0 FMAX M91\n"
                      "19 TOOL CALL 2 Z S9000\n"
                      "20 L X+1 Y+1 R0 FMAX M13\n"
                      "21 L Z+5 FMAX\n"
                      "22 L Z+0 F200.5\n"
                      "23 STOP\n"
                      "24 L Z+0 R0 FMAX M91\n"
                      "25 M30\n"
                      "26 END PGM PART MM\n");
  EXPECT_TRUE(p.ended);
  EXPECT_EQ(p.lines, 28u);
  EXPECT_EQ(p.tools, (std::vector<int>{1, 2}));
  EXPECT_EQ(p.blend, 0.013);
  EXPECT_FALSE(p.inches);
  ASSERT_EQ(p.sections.size(), 2u);
  EXPECT_EQ(p.sections[0].name, "rough");
  EXPECT_EQ(p.sections[0].tool, 1);
  EXPECT_EQ(p.sections[1].tool, 2);

  const std::string all = way(p);
  EXPECT_EQ(all.substr(0, all.find(", 10 0 -1") + 9),
            "(? ? inf), (0 0 inf), (0 0 5), 0 0 -1, 10 0 -1");
  for (const auto& m : p.moves)
    if (m.line == 17) {
      EXPECT_NEAR(std::hypot(m.to.x() - 15, m.to.y()), 5, 1e-9);
      EXPECT_GE(m.to.y(), -1e-9) << "clockwise over the top";
    }
  const auto& last = p.moves[p.moves.size() - 2];
  EXPECT_EQ(place(last.to), "1 1 0");
  EXPECT_EQ(last.line, 24u);
  EXPECT_EQ(last.tool, 2);
  EXPECT_EQ(last.spindle, 9000);
  EXPECT_EQ(last.feed, 200.5);
  EXPECT_TRUE(last.length_offset);
}

TEST(Klartext, ArcsByTheirAngle)
{
  const auto quarter = from({"CC X+0 Y+0", "CP IPA+90 DR+"});
  EXPECT_EQ(place(quarter.moves.back().to), "0 10 5");
  EXPECT_NEAR(length(quarter), 5 * pi, 1e-3);
  EXPECT_EQ(place(from({"CC X+0 Y+0", "CP PA+180 DR-"}).moves.back().to), "-10 0 5");
  EXPECT_NEAR(length(from({"CC X+0 Y+0", "CP PA+270 DR+"})), 15 * pi, 1e-3);
  EXPECT_NEAR(length(from({"CC X+0 Y+0", "CP PA+0 DR+"})), 20 * pi, 1e-3);
  // Two turns down.
  const auto helix = from({"CC IX-10 IY+0", "CP IPA-720 IZ-2 DR- F50"});
  EXPECT_EQ(place(helix.moves.back().to), "10 0 3");
  EXPECT_EQ(helix.moves.back().feed, 50);
  EXPECT_NEAR(length(helix), std::hypot(40 * pi, 2), 1e-2);
  const std::size_t half = helix.moves.size() / 4;
  EXPECT_LT(helix.moves[half - 2].to.y(), 0) << "clockwise to the front first";
  EXPECT_EQ(place(from({"CC X+0 Y+0", "CP IPA+90 Z+1 DR+"}).moves.back().to), "0 10 1");
}

TEST(Klartext, ArcsByTheirEndAndByTheirRadius)
{
  EXPECT_NEAR(length(from({"CC X+0 Y+0", "C X-10 Y+0 DR+"})), 10 * pi, 1e-3);
  EXPECT_NEAR(length(from({"CC X+0 Y+0", "C X+10 Y+0 DR-"})), 20 * pi, 1e-3);
  EXPECT_NEAR(length(from({"CR X+0 Y+10 R+10 DR+"})), 5 * pi, 1e-3);
  EXPECT_NEAR(length(from({"CR X+0 Y+10 R-10 DR+ R0 F20"})), 15 * pi, 1e-3);
  // Without words the pole is where the tool is.
  EXPECT_EQ(place(from({"CC", "L IX+3 IY+0", "CP IPA+180 DR+"}).moves.back().to),
            "7 0 5");
}

/// From Z to X, and from Y to Z, is positive.
TEST(Klartext, ArcsInThePlaneOfTheirPole)
{
  const auto zx = from({"CC X+10 Z-5", "C X+20 Z-5 DR+"});
  EXPECT_EQ(place(zx.moves.back().to), "20 0 -5");
  EXPECT_NEAR(length(zx), 5 * pi, 1e-3);
  const auto yz = from({"CC Y+10 Z+5", "CP IPA-90 DR-"});
  EXPECT_EQ(place(yz.moves.back().to), "10 10 15");
  EXPECT_EQ(place(from({"CC Y+10 Z+5", "CP IPA+90 DR+"}).moves.back().to), "10 10 -5");
}

TEST(Klartext, InchesHaveTheirOwnFeed)
{
  const auto p = read(numbered({"TOOL CALL 1 Z S1000",
                                "L X+1 Y+0 Z+0 FMAX M3",
                                "CYCL DEF 32.0 TOLERANCE",
                                "CYCL DEF 32.1 T0.001",
                                "L X+2 F100",
                                "M2"},
                               "INCH"));
  EXPECT_TRUE(p.inches);
  EXPECT_DOUBLE_EQ(p.moves.back().to.x(), 50.8);
  EXPECT_DOUBLE_EQ(p.moves.back().feed, 254) << "tenths of an inch a minute";
  EXPECT_DOUBLE_EQ(p.blend, 0.0254);
}

TEST(Klartext, ToolCallsAndTolerances)
{
  const auto p = from({"L X+1", "TOOL CALL S5000", "L X+2"});
  EXPECT_EQ(p.moves[1].spindle, 1000);
  EXPECT_EQ(p.moves[2].spindle, 5000);
  EXPECT_EQ(p.tools, std::vector<int>{1});
  EXPECT_EQ(p.blend, -1);
  EXPECT_EQ(from({"CYCL DEF 32.0 TOLERANCE",
                  "CYCL DEF 32.1 T0.01",
                  "L X+1",
                  "CYCL DEF 32.0 TOLERANCE",
                  "CYCL DEF 32.1",
                  "L X+2"})
                .blend,
            -1);
  EXPECT_EQ(
      from({"CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL 2", "M9"}).moves.size(), 1u);
  EXPECT_FALSE(p.ended);
}

TEST(Klartext, BlocksAreNumberedOneByOne)
{
  const auto why = [](const std::string& text) {
    return reading::refusal(text, ProgramForm::Klartext);
  };
  EXPECT_EQ(why("0 BEGIN PGM A MM\n2 M3\n"),
            "line 2, column 1: block 2 where 1 is due");
  EXPECT_EQ(why("0 BEGIN PGM A MM\n\n 1 M3\n1 M5\n"),
            "line 4, column 1: block 1 where 2 is due");
  EXPECT_EQ(why("0 BEGIN PGM A MM\nM3\n"), "line 2, column 1: 'M3' is not supported");
  EXPECT_EQ(why("0 M3\n"), "line 1, column 3: the program must begin with BEGIN PGM");
  EXPECT_EQ(why("0 BEGIN PGM A MM\n1 M30\n"), "line 2, column 1: END PGM is missing");
  EXPECT_EQ(why("0 BEGIN PGM A MM\n1 M30\n2 L X+1\n"),
            "line 3, column 3: a block behind the end of the program");
  EXPECT_EQ(why("0 BEGIN PGM A MM\n1 END PGM B MM\n"),
            "line 2, column 11: the program's name is A");
  EXPECT_EQ(why("0 BEGIN PGM A MM\n1 END PGM A INCH\n"),
            "line 2, column 13: the program began with another unit");
  EXPECT_EQ(why("0 BEGIN PGM A\n"),
            "line 1, column 14: the program's unit, MM or INCH is missing");
  EXPECT_EQ(why("0 BEGIN PGM A CM\n"),
            "line 1, column 15: the program's unit must be MM or INCH");
}

TEST(Klartext, RefusesWhatItDoesNotKnow)
{
  EXPECT_EQ(refusal("L X+1"), "line 4, column 3: L without a feed: no F so far");
  EXPECT_EQ(refusal("L X+1 A+5 F1"), "line 4, column 9: 'A+5' is not supported here");
  EXPECT_EQ(refusal("L X+1 RL F1"), "line 4, column 9: 'RL' is not supported");
  EXPECT_EQ(refusal("L X+1 FAUTO"), "line 4, column 9: 'FAUTO' is not supported");
  EXPECT_EQ(refusal("L X+1 X+2 F1"), "line 4, column 9: a second 'X'");
  EXPECT_EQ(refusal("L X+1.2.3 F1"), "line 4, column 5: 'X+1.2.3' is not supported");
  EXPECT_EQ(refusal("L X+1e3 F1"), "line 4, column 5: 'X+1e3' is not supported");
  EXPECT_EQ(refusal("L X+1 F0"), "line 4, column 9: F must be above 0");
  EXPECT_EQ(refusal("L XQ1 FMAX"), "line 4, column 5: 'XQ1' is not supported");
  EXPECT_EQ(refusal("L X+1 F1 M128"), "line 4, column 12: M128 is not supported");
  EXPECT_EQ(refusal("L Z+0 F1 M91"),
            "line 4, column 3: machine coordinates are supported with FMAX only");
  EXPECT_EQ(refusal("L IZ+0 FMAX M91"),
            "line 4, column 5: incremental machine coordinates");
  EXPECT_EQ(refusal("C X+1 Y+1 DR+ F1"),
            "line 4, column 3: C without a pole, CC, before it");
  EXPECT_EQ(refusal("CP IPA+90 F1"), "line 4, column 3: CP without DR+ or DR-");
  EXPECT_EQ(refusal("CP IPA+90 DR+ FMAX"), "line 4, column 3: CP with FMAX");
  EXPECT_EQ(refusal("CC X+1"), "line 4, column 3: CC needs two axes, or none");
  EXPECT_EQ(refusal("CR X+9 Y+0 DR+ F1"), "line 4, column 3: CR without R");
  EXPECT_EQ(refusal("CR X+9 Y+0 R+1 DR+ F1"),
            "line 4, column 3: R is too small to reach the end of the arc");
  EXPECT_EQ(refusal("RND R2"), "line 4, column 3: RND is not supported");
  EXPECT_EQ(refusal("CALL LBL 1"), "line 4, column 3: CALL is not supported");
  EXPECT_EQ(refusal("CYCL DEF 200 DRILLING ~"),
            "line 4, column 12: CYCL DEF 200 is not supported");
  EXPECT_EQ(refusal("TOOL CALL \"MILL\" Z S1"),
            "line 4, column 13: tools by name are not supported");
  EXPECT_EQ(refusal("TOOL CALL 2 Z S1 DL+0.5"),
            "line 4, column 20: a tool that differs from the table is not supported");
  EXPECT_EQ(refusal("TOOL CALL 2 S1"),
            "line 4, column 1: TOOL CALL without the spindle's axis, Z");
  EXPECT_EQ(refusal("TOOL CALL 2 Z S1\n4 L IX+1 FMAX"),
            "line 5, column 5: IX from an unknown position");
  EXPECT_EQ(refusal("STOP X+1"), "line 4, column 8: 'X+1' is not supported here");
  EXPECT_EQ(refusal("M3 M8"), "accepted");
  EXPECT_EQ(refusal("M3 X+1"), "line 4, column 6: 'X+1' is not supported here");
  EXPECT_EQ(refusal("M91"), "line 4, column 3: machine coordinates without X, Y or Z");
  EXPECT_EQ(refusal("L FMAX M91"),
            "line 4, column 3: machine coordinates without X, Y or Z");
  EXPECT_EQ(refusal("CYCL DEF 247 Q339=+0"), "accepted") << "as programs end";
  EXPECT_EQ(refusal("CYCL DEF 247 Q339=+2\n4 L Y+0 FMAX"),
            "line 5, column 5: a position in datum 2 after those in the control's own "
            "frame: only one work offset is supported");
}

TEST(Klartext, AnglesMustAgreeWithTheDirection)
{
  const auto why = [](const std::string& arc) {
    return reading::refusal(
        numbered({"TOOL CALL 1 Z S1 F9", "L X+9 Y+0 Z+5 FMAX", "CC X+0 Y+0", arc}),
        ProgramForm::Klartext);
  };
  EXPECT_EQ(why("CP IPA+90 DR+"), "accepted");
  for (const char* const arc : {"CP IPA+90 DR-", "CP IPA-90 DR+", "CP IPA+0 DR+"})
    EXPECT_EQ(why(arc).rfind("line 5, column 6: the angle must have the sign", 0), 0u)
        << arc << ": " << why(arc);
  EXPECT_EQ(why("CP DR+"), "line 5, column 3: CP without PA or IPA");
  EXPECT_EQ(why("CP IPA+90 X+1 DR+"), "line 5, column 13: CP goes by its angle");
  EXPECT_EQ(why("C X+0 Y+9 Z+1 DR+"),
            "line 5, column 13: C leaves the plane of its pole");
  EXPECT_EQ(why("C X+0 Y+8 DR+").rfind("line 5, column 3: the arc's radius is 9", 0),
            0u);
}
