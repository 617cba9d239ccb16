// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Programs of words as Grbl, Siemens and Heidenhain's DIN/ISO have them.
#include "reading.h"

using pointmill::formOf;
using pointmill::ProgramForm;
using reading::read;
using reading::refusal;
using reading::way;

namespace {

constexpr auto grbl = ProgramForm::Grbl;
constexpr auto siemens = ProgramForm::Siemens;
constexpr auto tnc = ProgramForm::HeidenhainIso;

/// Behind line 1, which sets everything.
std::string refusedBy(ProgramForm form, const std::string& block)
{
  const std::string head = form == siemens ? "G71 G90 G0 X0 Y0 Z5 F100\n"
                           : form == tnc   ? "%A G71 *\nG90 G00 X0 Y0 Z5 F100\n"
                                           : "G21 G90 G0 X0 Y0 Z5 F100\n";
  return refusal(head + block + "\n", form);
}

void expectCutting(const pointmill::ProgramMove& move, int tool, double rpm)
{
  EXPECT_FALSE(move.rapid) << "line " << move.line;
  EXPECT_EQ(move.tool, tool) << "line " << move.line;
  EXPECT_EQ(move.spindle, rpm) << "line " << move.line;
  EXPECT_TRUE(move.length_offset) << "line " << move.line;
}

} // namespace

TEST(GrblForm, OneToolFromTheStart)
{
  const auto p = read("(part for Grbl)\nG90 G94\nG17\nG21\nT1\nS8000 M3\nG54\nM8\n"
                      "G0 Z10\nX1 Y2\nG1 Z-1 F200\nG2 X3 I1\nG0 Z10\nM5 M9\nM30\n",
                      grbl);
  EXPECT_EQ(p.tools, std::vector<int>{1});
  EXPECT_EQ(p.blend, 0) << "the path is exact, always";
  EXPECT_TRUE(p.ended);
  expectCutting(p.moves[2], 1, 8000);
  EXPECT_EQ(p.moves.back().to, Eigen::Vector3d(3, 2, 10));
}

TEST(GrblForm, AToolIsFittedInThePauseBehindItsWord)
{
  const std::string first = "G21 G90\nT1\nS8000 M3\nG0 X0 Y0 Z10\nG1 Z0 F100\nG0 Z10\n";
  const auto p = read(first + "M5\n(Operation 2: finish)\nT2\nM0\nS9000 M3\n"
                              "G0 Z10\nX5 Y5\nG1 Z0\nM30\n",
                      grbl);
  EXPECT_EQ(p.tools, (std::vector<int>{1, 2}));
  expectCutting(p.moves.back(), 2, 9000);
  // The operator may have moved the machine.
  EXPECT_EQ(way(p), "(0 0 10), 0 0 0, (0 0 10), (? ? 10), (5 5 10), 5 5 0");
  ASSERT_EQ(p.sections.size(), 2u);
  EXPECT_EQ(p.sections[1].name, "finish");
  EXPECT_EQ(p.sections[1].tool, 2);

  EXPECT_EQ(refusal(first + "T2\nG1 Z0\n", grbl),
            "line 8, column 1: T2 is not fitted yet: there was no M0");
  EXPECT_EQ(refusal(first + "T2\nM0\n", grbl),
            "line 8, column 1: T2 while the spindle turns");
  EXPECT_EQ(refusal(first + "M0\nX1\n", grbl), "accepted");
}

TEST(GrblForm, HasLessThanRs274)
{
  EXPECT_EQ(refusedBy(grbl, "T1 M6"),
            "line 2, column 4: M6 (tool change) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "G43 H1"),
            "line 2, column 5: H (tool length) is not supported");
  EXPECT_EQ(refusedBy(grbl, "G43"),
            "line 2, column 1: G43 (tool length) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "G64"),
            "line 2, column 1: G64 (path mode) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "G61.1"),
            "line 2, column 1: G61.1 (path mode) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "G90.1"),
            "line 2, column 1: G90.1 (arc distance mode) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "G59.1"),
            "line 2, column 1: G59.1 (work offset) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "M7"),
            "line 2, column 1: M7 (coolant) is not a word of Grbl");
  EXPECT_EQ(refusedBy(grbl, "%"), "line 2, column 1: '%' is not supported");
  EXPECT_EQ(refusedBy(grbl, "O1"),
            "line 2, column 1: O (subroutine or program number) is not supported");
  EXPECT_EQ(refusedBy(grbl, "G40 G49 G80 G61"), "accepted");
}

TEST(SiemensForm, AProgramWithTwoTools)
{
  const auto p = read("; %_N_PART_MPF\n"
                      "N10 G90 G94\nN20 G71\nN30 G64\nN40 G17\n"
                      "N50 MSG(\"Operation 1: rough\")\n"
                      "N60 G0 SUPA Z0 D0\n"
                      "N70 T1 D1\nN80 M6\nN90 S12000 M3\nN100 G54\nN110 M8\n"
                      "N120 G0 X10 Y0\nN130 Z5\nN140 G1 Z-1 F300\n"
                      "N150 G2 X20 Y0 I5 J0\nN160 G3 X10 Y0 I=AC(15) J=AC(0)\n"
                      "N170 G2 X20 Y0 CR=5\nN180 G1 X=IC(2) Y=AC(1)\nN190 G0 Z5\n"
                      "N200 G0 SUPA Z0 D0\nN210 T2 D1\nN220 M6\nN230 S9000 M3\n"
                      "N240 G0 X1 Y1\nN250 Z5\nN260 G1 Z0\nN270 M5\nN280 M30\n",
                      siemens);
  EXPECT_EQ(p.tools, (std::vector<int>{1, 2}));
  EXPECT_TRUE(p.ended);
  EXPECT_TRUE(std::isinf(p.blend)) << "G64 has no bound";
  EXPECT_EQ(way(p).substr(0, 40), "(? ? inf), (10 0 inf), (10 0 5), 10 0 -1");
  ASSERT_EQ(p.sections.size(), 2u);
  EXPECT_EQ(p.sections[0].name, "rough");
  expectCutting(p.moves[3], 1, 12000);
  expectCutting(p.moves.back(), 2, 9000);
  for (const auto& m : p.moves)
    if (m.line == 16 || m.line == 17 || m.line == 18) {
      EXPECT_NEAR(std::hypot(m.to.x() - 15, m.to.y()), 5, 1e-9) << "line " << m.line;
    }
    else if (m.line == 19) {
      EXPECT_EQ(m.to, Eigen::Vector3d(22, 1, -1));
    }
}

TEST(SiemensForm, LengthsAreInForceByD)
{
  const std::string head = "G71 G90 G0 SUPA Z0 D0\nT1\nM6\nS100 M3\n";
  const auto p = read(head + "G0 X0 Y0\nZ5\nG1 Z0 F100\n", siemens);
  EXPECT_FALSE(p.moves.back().length_offset);
  expectCutting(
      read(head + "D1\nG0 X0 Y0\nZ5\nG1 Z0 F100\n", siemens).moves.back(), 1, 100);
  EXPECT_EQ(refusal(head + "D1\nG0 X0 Y0\nZ5\nD0\nG1 Z0 F100\n", siemens),
            "line 9, column 1: G1 from an unknown position: Z is not set");
}

TEST(SiemensForm, HowCornersAreTaken)
{
  const std::string head = "G710 G90 G0 X0 Y0 Z5 F100\n";
  const auto blend = [&](const std::string& words) {
    return read(head + words + "\nG1 X1\n", siemens).blend;
  };
  EXPECT_EQ(blend(""), -1);
  EXPECT_EQ(blend("G60"), 0);
  EXPECT_EQ(blend("G642 CTOL=0.02"), 0.02);
  EXPECT_EQ(blend("CTOL=0.02\nG642"), 0.02);
  EXPECT_EQ(blend("G642"), -1) << "its tolerance is a setting of the machine";
  EXPECT_EQ(blend("G641 ADIS=0.3"), 0.3);
  EXPECT_EQ(blend("CYCLE832(0.05,1,1)"), 0.05);
  EXPECT_EQ(blend("CYCLE832(0.05,1,1)\nG1 X2\nCYCLE832()"), -1);
  EXPECT_EQ(blend("SOFT FFWON\nG60 G601"), 0);
}

TEST(SiemensForm, Units)
{
  const auto p = read("G700 G90 G0 X1 Y0 Z0\nG1 X2 F10\nG4 F2\nX3\n", siemens);
  EXPECT_DOUBLE_EQ(p.moves.back().to.x(), 3 * 25.4);
  EXPECT_DOUBLE_EQ(p.moves.back().feed, 254) << "G4's F is a time";
  EXPECT_EQ(
      refusal("G70 G90 G0 X1 Y0 Z0\nG1 X2 F10", siemens),
      "line 2, column 7: F after G70 is in the machine's own unit; G700 says inches");
  EXPECT_EQ(refusal("G90 G0 X1", siemens),
            "line 1, column 8: X before G71 or G70: its unit is unknown");
}

TEST(SiemensForm, RefusesWhatItDoesNotKnow)
{
  EXPECT_EQ(refusedBy(siemens, "G21"),
            "line 2, column 1: G21 (units) is not a word of Siemens");
  EXPECT_EQ(refusedBy(siemens, "G43"),
            "line 2, column 1: G43 (tool length) is not a word of Siemens");
  EXPECT_EQ(refusedBy(siemens, "X1 (a)"), "line 2, column 4: '(' is not supported");
  EXPECT_EQ(refusedBy(siemens, "%"), "line 2, column 1: '%' is not supported");
  EXPECT_EQ(refusedBy(siemens, "TRANS X10"),
            "line 2, column 1: TRANS is not supported");
  EXPECT_EQ(refusedBy(siemens, "CYCLE81(1,2)"),
            "line 2, column 1: CYCLE81 (canned drilling) is not supported");
  EXPECT_EQ(refusedBy(siemens, "R1=5"),
            "line 2, column 1: R (parameter) is not supported");
  EXPECT_EQ(refusedBy(siemens, "G2 X1 Y0 I1 TURN=2"),
            "line 2, column 13: TURN= is not supported");
  EXPECT_EQ(refusedBy(siemens, "T=\"MILL\""),
            "line 2, column 3: tools by name are not supported");
  EXPECT_EQ(refusedBy(siemens, "X=AC(5"), "line 2, column 1: a ')' is missing");
  EXPECT_EQ(refusedBy(siemens, "F=AC(5)"),
            "line 2, column 3: AC and IC belong to X Y Z I J K");
  EXPECT_EQ(refusedBy(siemens, "X="), "line 2, column 1: X has no number");
  EXPECT_EQ(refusedBy(siemens, "G2 X1 CR=0.1"),
            "line 2, column 7: R is too small to reach the end of the arc");
  EXPECT_EQ(refusedBy(siemens, "G1 SUPA Z0"),
            "line 2, column 4: machine coordinates are supported with G0 only");
  EXPECT_EQ(
      refusedBy(siemens, "G54 X1"),
      "line 2, column 5: a position in G54 after those in the control's own frame: "
      "only one work offset is supported");
  EXPECT_EQ(refusedBy(siemens, "M6"), "line 2, column 1: M6 without a T word");
  EXPECT_EQ(refusedBy(siemens, "G4"), "line 2, column 1: G4 needs F or S, at least 0");
  EXPECT_EQ(refusedBy(siemens, "G1 X1 CR=5"), "line 2, column 7: R without G2 or G3");
}

TEST(HeidenhainIsoForm, AProgramWithTwoTools)
{
  const auto p = read("%PART G71 *\n"
                      "N10 G30 G17 X+0 Y+0 Z-20 *\nN20 G31 G90 X+50 Y+50 Z+0 *\n"
                      "N30 G90 G94 G17\nN40 G62 T0.02\n"
                      "N50 ; Operation 1: rough\n"
                      "N60 G00 Z+0 M91\nN70 T1 G17 S12000\nN80 G51 T2\nN90 M03\n"
                      "N100 G00 Z+10\nN110 G00 X+10 Y+0\nN120 G01 Z-1 F300\n"
                      "N130 I+15 J+0\nN140 G02 X+20 Y+0\n"
                      "N150 G90 I+15 J+0 G03 X+10 Y+0\nN160 G02 X+20 Y+0 R+5\n"
                      "N170 G91 G01 X+2\nN180 G90 G00 Z+10\n"
                      "N190 G00 Z+0 M91\nN200 T2 G17 S9000\nN210 M13\n"
                      "N220 G00 Z+10\nN230 X+1 Y+1\nN240 G04 F2\nN250 G01 Z+0\n"
                      "N260 M30\nN99999999 %PART G71 *\n",
                      tnc);
  EXPECT_EQ(p.tools, (std::vector<int>{1, 2}));
  EXPECT_TRUE(p.ended);
  EXPECT_EQ(p.blend, 0.02);
  ASSERT_EQ(p.sections.size(), 2u);
  EXPECT_EQ(p.sections[0].name, "rough");
  EXPECT_EQ(p.sections[1].tool, 2);
  EXPECT_EQ(way(p).substr(0, 40), "(? ? inf), (? ? 10), (10 0 10), 10 0 -1,");
  expectCutting(p.moves[3], 1, 12000);
  expectCutting(p.moves.back(), 2, 9000);
  EXPECT_EQ(p.moves.back().feed, 300) << "G04's F is a time";
  double sum[3] = {};
  for (const auto& m : p.moves)
    if (m.line >= 15 && m.line <= 17) {
      EXPECT_NEAR(std::hypot(m.to.x() - 15, m.to.y()), 5, 1e-9) << "line " << m.line;
      sum[m.line - 15] += m.to.y();
    }
  EXPECT_GT(sum[0], 0) << "clockwise over the top";
  EXPECT_GT(sum[1], 0) << "and back the same way";
  EXPECT_GT(sum[2], 0);
}

TEST(HeidenhainIsoForm, InchesHaveTheirOwnFeed)
{
  const auto p = read("%A G70\nG90 G00 X+1 Y+0 Z+0\nG01 X+2 F100\nM2\n", tnc);
  EXPECT_DOUBLE_EQ(p.moves.back().to.x(), 50.8);
  EXPECT_DOUBLE_EQ(p.moves.back().feed, 254) << "tenths of an inch a minute";
}

TEST(HeidenhainIsoForm, RefusesWhatItDoesNotKnow)
{
  EXPECT_EQ(
      refusal("N10 G90\n", tnc),
      "line 1, column 1: the program must begin with '%', its name and G71 or G70");
  EXPECT_EQ(refusal("%A\n", tnc),
            "line 1, column 3: G71 or G70 must stand behind the program's name");
  EXPECT_EQ(refusal("% G71\n", tnc), "line 1, column 2: the program's name is missing");
  EXPECT_EQ(refusal("%A G71 X1\n", tnc),
            "line 1, column 8: 'X' behind the program's unit");
  EXPECT_EQ(refusedBy(tnc, "T1 M6"),
            "line 3, column 4: M6 (tool change) is not a word of Heidenhain ISO");
  EXPECT_EQ(refusedBy(tnc, "G28 Z0"),
            "line 3, column 1: G28 (mirror image) is not supported");
  EXPECT_EQ(refusedBy(tnc, "G54 X1"),
            "line 3, column 1: G54 (datum shift) is not supported");
  EXPECT_EQ(
      refusedBy(tnc, "G02 X1 Y1"),
      "line 3, column 1: an arc without radius, and without a pole, I J, before it");
  EXPECT_EQ(refusedBy(tnc, "G01 Z+0 M91"),
            "line 3, column 9: machine coordinates are supported with G00 only");
  EXPECT_EQ(refusedBy(tnc, "X1 * X2"),
            "line 3, column 6: 'X' behind the end of the block");
  EXPECT_EQ(refusedBy(tnc, "G98 L1"),
            "line 3, column 5: L (repetition) is not supported");
}

TEST(FormOf, IsToldByWhatOnlyOneHas)
{
  EXPECT_EQ(formOf(""), ProgramForm::Rs274);
  EXPECT_EQ(formOf("%\nO1001 (PART)\nG21\n"), ProgramForm::Rs274);
  EXPECT_EQ(formOf("(SUPA and MSG(are words of others)\nT1 M6\n"), ProgramForm::Rs274);
  EXPECT_EQ(formOf("G90 (T1 D1)\nT1 M6\nX1 Y2 ; CR=\n"), ProgramForm::Rs274);
  EXPECT_EQ(formOf("; a comment\nG21\n"), ProgramForm::Rs274);
  EXPECT_EQ(formOf("(PointMill for Grbl 1.1)\nG21\n"), ProgramForm::Grbl);
  EXPECT_EQ(formOf("; grbl\nG21\n"), ProgramForm::Grbl);
  EXPECT_EQ(formOf("\n0 BEGIN PGM A MM\n"), ProgramForm::Klartext);
  EXPECT_EQ(formOf("%A G71 *\nN10 G30\n"), tnc);
  EXPECT_EQ(formOf("N5 %A G70"), tnc);
  for (const char* const words : {"g0 supa z0 d0",
                                  "MSG(\"a\")",
                                  "N10 G2 X1 CR=5",
                                  "X=AC(5)",
                                  "G642 CTOL=0.01",
                                  "CYCLE832(0.01)",
                                  "G17 G710 G40",
                                  "T1 D1"})
    EXPECT_EQ(formOf(std::string("; part\nN10 G90\n") + words), siemens) << words;
}
