// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "reading.h"

#include <fstream>
#include <limits>

using pointmill::Program;
using reading::read;
using reading::refusal;
using reading::way;

namespace {

/// After a known position, in line 3.
std::string refusalOf(const std::string& block)
{
  return refusal("G21 G90 F100\nG0 X0 Y0 Z5\n" + block + "\n");
}

#define EXPECT_REFUSED(block, part)                                                    \
  EXPECT_EQ(refusalOf(block).rfind(part, 0), 0u) << refusalOf(block)

const double pi = std::acos(-1.0);

/// An arc from (@p x, @p y) at Z5.
Program arc(const std::string& block, double x, double y)
{
  return read("G21 G90 F100\nG0 X" + std::to_string(x) + " Y" + std::to_string(y) +
              " Z5\n" + block + "\n");
}

/// Largest distance of the chords from a circle about @p centre, in the plane X Y.
double deviation(const Program& program, Eigen::Vector2d centre, double radius)
{
  double worst = 0;
  for (std::size_t i = 1; i < program.moves.size(); ++i)
    for (const double t : {0.0, 0.5, 1.0}) {
      const Eigen::Vector3d p =
          program.moves[i].from + t * (program.moves[i].to - program.moves[i].from);
      worst = std::max(worst, std::abs((p.head<2>() - centre).norm() - radius));
    }
  return worst;
}

double length(const Program& program)
{
  double sum = 0;
  for (std::size_t i = 1; i < program.moves.size(); ++i)
    sum += (program.moves[i].to - program.moves[i].from).norm();
  return sum;
}

} // namespace

TEST(GCodeReader, HandMadeText)
{
  const auto p = read("%\r\n"
                      "( a comment ) ; and another\r\n"
                      "\r\n"
                      "N1 g 2 1 G9 0 (in the middle) t3 m 6\r\n"
                      "n2G43H3S12000M3M8\r\n"
                      "g00x1 0 . 5y-.25z+7.\r\n"
                      "G01 Z - 1 F 2 5 0 . 5\r\n"
                      "\tX11 ; (unfinished\r\n"
                      "M4 Y3\r\n"
                      "M5 M9\r\n"
                      "M30\r\n"
                      "%\r\n"
                      "this is never read\r\n");
  ASSERT_EQ(p.moves.size(), 4u);
  EXPECT_EQ(p.moves[0].to, Eigen::Vector3d(10.5, -0.25, 7));
  EXPECT_TRUE(p.moves[0].rapid);
  EXPECT_FALSE(p.moves[0].from_known);
  EXPECT_EQ(p.moves[0].feed, 0);
  EXPECT_EQ(p.moves[1].from, p.moves[0].to);
  EXPECT_EQ(p.moves[1].to, Eigen::Vector3d(10.5, -0.25, -1));
  EXPECT_FALSE(p.moves[1].rapid);
  EXPECT_TRUE(p.moves[1].from_known);
  EXPECT_EQ(p.moves[1].feed, 250.5);
  EXPECT_EQ(p.moves[1].spindle, 12000);
  EXPECT_EQ(p.moves[1].tool, 3);
  EXPECT_EQ(p.moves[1].line, 7u);
  EXPECT_EQ(p.moves[2].to.x(), 11);
  EXPECT_EQ(p.moves[3].spindle, -12000);
  EXPECT_EQ(p.tools, std::vector<int>{3});
  EXPECT_EQ(p.lines, 11u);
  EXPECT_TRUE(p.ended);
  EXPECT_EQ(p.blend, -1);
}

TEST(GCodeReader, TheEndOfTheFileIsNoEndOfTheProgram)
{
  EXPECT_FALSE(read("G21\nG0 Z5").ended);
  EXPECT_FALSE(read("%\nG21\nG0 Z5\n%\n").ended);
  EXPECT_TRUE(read("M2").ended);
  EXPECT_FALSE(read("").ended);
  EXPECT_EQ(read("").lines, 0u);
  EXPECT_EQ(read("G21\nG0 Z5").lines, 2u);
}

TEST(GCodeReader, WhatIsUnknownStaysUnknown)
{
  const auto p = read("G21 G90\n"
                      "G0 Z20\n"
                      "X1 Y2\n"
                      "G53 G0 Z0\n"
                      "T1 M6\n"
                      "G43 H1\n"
                      "G0 Z10\n"
                      "X5 Y5\n"
                      "T2 M6\n"
                      "G0 X1 Y1\n"
                      "G53 X0 Z-5\n"
                      "G53 Z-50\n");
  ASSERT_EQ(p.moves.size(), 8u);
  EXPECT_TRUE(p.moves[0].from.array().isNaN().all());
  EXPECT_TRUE(std::isnan(p.moves[0].to.x()));
  EXPECT_EQ(p.moves[0].to.z(), 20);
  EXPECT_EQ(p.moves[1].to, Eigen::Vector3d(1, 2, 20));
  // The top of the machine is above everything and stays so through a tool change.
  EXPECT_EQ(p.moves[2].to.z(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(p.moves[2].to.x(), 1);
  EXPECT_EQ(p.moves[3].from.z(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(p.moves[3].from.x()));
  EXPECT_FALSE(p.moves[3].from_known);
  EXPECT_EQ(p.moves[4].to, Eigen::Vector3d(5, 5, 10));
  // Another tool at a height of the part frame: its tip may be anywhere.
  EXPECT_TRUE(std::isnan(p.moves[5].to.z()));
  EXPECT_TRUE(std::isnan(p.moves[6].to.x()));
  // Homed machines back off from their top by a little; far below it is anywhere.
  EXPECT_EQ(p.moves[6].to.z(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(p.moves[7].to.z(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(p.moves[6].to.y(), 1);
}

TEST(GCodeReader, PathTolerance)
{
  EXPECT_EQ(read("G61").blend, 0);
  EXPECT_EQ(read("G21\nG64 P0.05").blend, 0.05);
  EXPECT_EQ(read("G21\nG64 P0.05").merge, 0.05);
  EXPECT_EQ(read("G21\nG64 P0.05 Q0").merge, 0);
  EXPECT_EQ(read("G20\nG64 P0.01\nG64 P0.001").blend, 0.254);
  EXPECT_TRUE(std::isinf(read("G64").blend));
}

TEST(GCodeReader, IncrementalAndInches)
{
  const auto p = read("G20 G90 F10\nG0 X1 Y1 Z1\nG91 G1 X.5\nZ-1\nG90 X0\nG21\nX10\n");
  ASSERT_EQ(p.moves.size(), 5u);
  EXPECT_DOUBLE_EQ(p.moves[1].to.x(), 1.5 * 25.4);
  EXPECT_DOUBLE_EQ(p.moves[2].to.z(), 0.0);
  EXPECT_DOUBLE_EQ(p.moves[3].to.x(), 0.0);
  EXPECT_DOUBLE_EQ(p.moves[4].to.x(), 10.0);
  EXPECT_DOUBLE_EQ(p.moves[4].feed, 254.0);
  EXPECT_TRUE(p.inches);
}

TEST(GCodeReader, ArcsByOffsets)
{
  const auto half = arc("G2 X10 I5", 0, 0);
  EXPECT_LT(deviation(half, {5, 0}, 5), 1.0001e-4);
  EXPECT_NEAR(length(half), pi * 5, 1e-3);
  EXPECT_GT(half.moves[half.moves.size() / 2].to.y(), 4.9)
      << "clockwise is over the top";
  EXPECT_EQ(half.moves.back().to, Eigen::Vector3d(10, 0, 5));

  const auto quarter = arc("G3 X0 Y10 I-10", 10, 0);
  EXPECT_LT(deviation(quarter, {0, 0}, 10), 1.0001e-4);
  EXPECT_NEAR(length(quarter), pi * 5, 1e-3);

  const auto full = arc("G3 J-4", 1, 2);
  EXPECT_LT(deviation(full, {1, -2}, 4), 1.0001e-4);
  EXPECT_NEAR(length(full), 2 * pi * 4, 1e-3);
  EXPECT_LT(full.moves[full.moves.size() / 4].to.x(), -2.9) << "to the left first";

  const auto helix = arc("G2 X0 Y0 Z-1 I3", 0, 0);
  EXPECT_NEAR(length(helix), std::hypot(2 * pi * 3, 6), 1e-3);
  EXPECT_EQ(helix.moves.back().to.z(), -1);
}

TEST(GCodeReader, ArcsByRadius)
{
  const auto minor = arc("G3 X0 Y10 R10", 10, 0);
  EXPECT_LT(deviation(minor, {0, 0}, 10), 1.0001e-4);
  EXPECT_NEAR(length(minor), pi * 5, 1e-3);
  const auto major = arc("G3 X0 Y10 R-10", 10, 0);
  EXPECT_LT(deviation(major, {10, 10}, 10), 1.0001e-4);
  EXPECT_NEAR(length(major), pi * 15, 1e-3);
  const auto other = arc("G2 X0 Y10 R10", 10, 0);
  EXPECT_LT(deviation(other, {10, 10}, 10), 1.0001e-4);
  EXPECT_NEAR(length(other), pi * 5, 1e-3);
  EXPECT_NEAR(length(arc("G2 X0 Y0 R5", 10, 0)), pi * 5, 1e-3);
}

TEST(GCodeReader, ArcsInTheOtherPlanes)
{
  // Counter-clockwise in G18 turns from Z to X, in G19 from Y to Z.
  const auto zx = arc("G18 G3 X10 Z-5 K-10", 0, 0);
  EXPECT_EQ(zx.moves.back().to, Eigen::Vector3d(10, 0, -5));
  for (const auto& m : zx.moves)
    EXPECT_NEAR(std::hypot(m.to.x(), m.to.z() + 5), 10, 1e-9);
  EXPECT_NEAR(length(zx), pi * 5, 1e-3);
  const auto yz = arc("G19 G3 Y-10 Z5 J-5", 0, 0);
  for (const auto& m : yz.moves)
    EXPECT_NEAR(std::hypot(m.to.y() + 5, m.to.z() - 5), 5, 1e-9);
  EXPECT_GT(yz.moves[yz.moves.size() / 2].to.z(), 9);
}

TEST(GCodeReader, ChordErrorCanBeSet)
{
  std::istringstream in("G21 G90 F100\nG0 X0 Y0 Z5\nG2 X10 I5\n");
  pointmill::GCodeReader reader;
  reader.setChordError(0.1);
  const auto p = reader.read(in);
  EXPECT_LT(p.moves.size(), 12u);
  EXPECT_LT(deviation(p, {5, 0}, 5), 0.1001);
  reader.setChordError(0);
  std::istringstream again("G21\n");
  EXPECT_THROW(reader.read(again), pointmill::ParameterError);
}

TEST(GCodeReader, RefusesWordsWithLineAndColumn)
{
  EXPECT_EQ(refusalOf("X1 Y1 G81 R1"),
            "line 3, column 7: G81 (canned drilling) is not supported");
  EXPECT_EQ(refusalOf("  g2.5"), "line 3, column 3: G2.5 is not known");
  EXPECT_REFUSED("G1.23", "line 3, column 1: the number after G is no code");
  EXPECT_REFUSED("G-1", "line 3, column 1: the number after G is no code");
  EXPECT_REFUSED("G41 D1", "line 3, column 5: D (cutter radius) is not supported");
  EXPECT_REFUSED("G41", "line 3, column 1: G41 (cutter compensation)");
  EXPECT_REFUSED("G10 L2", "line 3, column 5: L (repetition)");
  EXPECT_REFUSED("M98 P1", "line 3, column 1: M98 (subprogram)");
  EXPECT_REFUSED("M21", "line 3, column 1: M21 is not known");
  EXPECT_REFUSED("X1 A90", "line 3, column 4: A (rotary axis)");
  EXPECT_REFUSED("o100 sub", "line 3, column 1: O (subroutine or program number)");
  EXPECT_REFUSED("#1=5", "line 3, column 1: '#' (parameters)");
  EXPECT_REFUSED("X#1", "line 3, column 2: '#' (parameters)");
  EXPECT_REFUSED("X[1+2]", "line 3, column 2: '[' (expressions)");
  EXPECT_REFUSED("/X1", "line 3, column 1: '/' (block delete)");
  EXPECT_REFUSED("X1 \xC3\xA4", "line 3, column 4: byte 0xC3");
  EXPECT_REFUSED("X1E5", "line 3, column 3: E without G187");
  EXPECT_REFUSED("X1 N5", "line 3, column 4: N must be the first word");
}

TEST(GCodeReader, RefusesMalformedText)
{
  EXPECT_REFUSED("X", "line 3, column 1: X has no number");
  EXPECT_REFUSED("X Y1", "line 3, column 1: X has no number");
  EXPECT_REFUSED("X-", "line 3, column 1: X has no number");
  EXPECT_REFUSED("X.", "line 3, column 1: X has no number");
  EXPECT_REFUSED("X1.2.3", "line 3, column 5: '.'");
  EXPECT_REFUSED("X--1", "line 3, column 1: X has no number");
  EXPECT_REFUSED("X1-2", "line 3, column 3: '-'");
  EXPECT_REFUSED("X123456789012345678", "line 3, column 1: X has more than 17 digits");
  EXPECT_REFUSED("X1 (open", "line 3, column 4: the comment is not closed");
  EXPECT_REFUSED("(a (b))", "line 3, column 4: a comment inside a comment");
  EXPECT_REFUSED("X1)", "line 3, column 3: ')'");
  EXPECT_REFUSED("% X1", "line 3, column 1: '%' must stand alone");
  EXPECT_REFUSED("X1 %", "line 3, column 4: '%' must stand alone");
  EXPECT_REFUSED(std::string(300, ' '), "line 3, column 256: the line is longer");
  EXPECT_REFUSED(std::string("X1 \0 Y1", 7), "line 3, column 4: byte 0x00");
  EXPECT_EQ(refusal(std::string(1000000, 'X')).rfind("line 1, column 256", 0), 0u);
  EXPECT_EQ(refusalOf(std::string(255, ' ')), "accepted");
}

TEST(GCodeReader, RefusesConflicts)
{
  EXPECT_EQ(refusalOf("G0 G1 X1"),
            "line 3, column 4: G1 and G0: two motion words in one block");
  EXPECT_REFUSED("G90 X1 G91", "line 3, column 8: G91 and G90: two distance mode");
  EXPECT_REFUSED("G17 G18", "line 3, column 5: G18 and G17: two plane");
  EXPECT_REFUSED("G20 G21", "line 3, column 5: G21 and G20: two units");
  EXPECT_REFUSED("G61 G64", "line 3, column 5: G64 and G61: two path mode");
  EXPECT_REFUSED("G4 G53 P1", "line 3, column 4: G53 and G4: two non-modal");
  EXPECT_REFUSED("M3 M5", "line 3, column 4: M5 and M3: two spindle");
  EXPECT_REFUSED("M8 M9", "line 3, column 4: M9 and M8: two coolant");
  EXPECT_REFUSED("M0 M30", "line 3, column 4: M30 and M0: two program stop");
  EXPECT_REFUSED("X1 Y1 x2", "line 3, column 7: a second X word");
  EXPECT_REFUSED("P1", "line 3, column 1: P without G4, G64");
  EXPECT_REFUSED("Q1", "line 3, column 1: Q without G64 or G5.1");
  EXPECT_REFUSED("H1", "line 3, column 1: H without G43");
  EXPECT_REFUSED("G1 X1 I1", "line 3, column 7: I without G2 or G3");
  EXPECT_REFUSED("G4", "line 3, column 1: G4 needs P");
  EXPECT_REFUSED("G4 P1 X1", "line 3, column 7: G4 beside motion");
  EXPECT_REFUSED("G20 F1", "line 3, column 5: F in a block that changes the unit");
  EXPECT_REFUSED("G55 X1", "line 3, column 5: a position in G55 after those in G54");
  EXPECT_REFUSED("G64 P-1", "line 3, column 1: G64 with a negative");
  EXPECT_REFUSED("T1 M6\nG43 H2", "line 4, column 5: H2 is not the length of tool 1");
  EXPECT_REFUSED("T1.5", "line 3, column 1: T must be a whole number");
  EXPECT_REFUSED("T-1", "line 3, column 1: T must be a whole number");
  EXPECT_REFUSED("M6", "line 3, column 1: M6 without a T word");
  EXPECT_REFUSED("F0", "line 3, column 1: F must be above 0");
  EXPECT_REFUSED("S-5", "line 3, column 1: S must not be negative");
  EXPECT_REFUSED("X100001", "line 3, column 1: X is beyond 100 m");
}

TEST(GCodeReader, RefusesMovesThatAreNotDetermined)
{
  EXPECT_EQ(refusal("G0 X1"),
            "line 1, column 4: X before G20 or G21: its unit is unknown");
  EXPECT_EQ(refusal("G21\nX1"), "line 2, column 1: X without G0, G1, G2 or G3");
  EXPECT_REFUSED("G80\nX1", "line 4, column 1: X without G0");
  EXPECT_EQ(refusal("G21 F1\nG0 X1 Z1\nG1 X2"),
            "line 3, column 1: G1 from an unknown position: Y is not set");
  EXPECT_EQ(refusal("G21\nG0 X1 Y1 Z1\nG1 X2"),
            "line 3, column 1: G1 without a feed: no F so far");
  EXPECT_EQ(refusal("G21 G91\nG0 X1"),
            "line 2, column 4: G91: X from an unknown position");
  EXPECT_REFUSED("G53 G0 Z0\nG1 Z5",
                 "line 4, column 1: G1 from an unknown position: Z");
  EXPECT_REFUSED("T1 M6\nG1 Z5", "line 4, column 1: G1 from an unknown position: X");
  EXPECT_REFUSED("G43 H1\nG1 Z5", "line 4, column 1: G1 from an unknown position: Z");
  EXPECT_REFUSED("G53 G1 Z0", "line 3, column 1: G53 is supported with G0 only");
  EXPECT_REFUSED("G91 G53 Z0", "line 3, column 5: G53 in incremental mode");
  EXPECT_REFUSED("G53", "line 3, column 1: G53 without X, Y or Z");
}

TEST(GCodeReader, RefusesArcs)
{
  EXPECT_REFUSED("G2 X10", "line 3, column 1: an arc without centre or radius");
  EXPECT_REFUSED("G2", "line 3, column 1: G2 without its words");
  EXPECT_REFUSED("G2 X10 I5 R5", "line 3, column 8: I beside R");
  EXPECT_REFUSED("G2 X10 I5 K1", "line 3, column 11: K does not belong to plane G17");
  EXPECT_REFUSED("G2 X10 I4.9", "line 3, column 1: the arc's radius is 4.9");
  EXPECT_REFUSED("G2 X10 R4.9", "line 3, column 8: R is too small");
  EXPECT_REFUSED("G2 X0 Y0 R5", "line 3, column 1: an arc with R must not end");
  EXPECT_REFUSED("G2 X0 Y0 I0", "line 3, column 1: the arc's radius is 0");
  EXPECT_EQ(refusalOf("G2 X10 I5.002"), "accepted");
}

TEST(GCodeReader, RefusesAStreamThatFails)
{
  std::ifstream missing("/nonexistent/program.ngc");
  EXPECT_THROW(pointmill::readProgram(missing), pointmill::DataError);
}

TEST(GCodeReader, ReferencePoints)
{
  // Over the block's point to the machine's place, which is unknown but for its top.
  EXPECT_EQ(way(read("G21 G90\nG28 G91 Z0.\nG90\nG0 X1 Y2\nZ5\nG28 Z9\nG0 Z5\n")),
            "(? ? inf), (1 2 inf), (1 2 5), (1 2 9), (1 2 inf), (1 2 5)");
  EXPECT_EQ(way(read("G21 G90\nG0 X1 Y2 Z5\nG91 G28 X3 Y0\nG90 G0 X1 Y2\nG28\n")),
            "(1 2 5), (4 2 5), (? ? 5), (1 2 5), (? ? inf)");
  // A second reference point may be anywhere, and low.
  EXPECT_EQ(way(read("G21 G90\nG0 X1 Y2 Z5\nG30 P2 Z8\n")),
            "(1 2 5), (1 2 8), (1 2 -inf)");
  EXPECT_EQ(refusal("G21 G91\nG28 Z1"),
            "line 2, column 5: G91: Z from an unknown position");
  EXPECT_REFUSED("G1 G28 Z0", "line 3, column 4: G28 beside G1");
  EXPECT_REFUSED("G28.1", "line 3, column 1: G28.1 (setting of a reference point)");
  EXPECT_REFUSED("G28 Z5\nG1 Z2", "line 4, column 1: G1 from an unknown position: Z");
}

TEST(GCodeReader, ShiftedFrames)
{
  const std::string head = "G21 G90 F100\nG0 X1 Y2 Z3\n";
  EXPECT_EQ(way(read(head + "G92 X10 Z0\nG1 X11\nZ1\nG91 X1\n")),
            "(1 2 3), 2 2 3, 2 2 4, 3 2 4");
  EXPECT_EQ(way(read(head + "G92 X10\nG92.2\nG1 X5\nG92.3\nX12\nG92.1\nX7\n")),
            "(1 2 3), 5 2 3, 3 2 3, 7 2 3");
  // Absolute centres are in the shifted frame, too.
  EXPECT_EQ(read(head + "G92 X0\nG90.1 G2 X10 Y2 I5 J2\n").moves.back().to,
            Eigen::Vector3d(11, 2, 3));
  // In inches.
  EXPECT_EQ(way(read("G20 G90 F10\nG0 X1 Y1 Z1\nG92 X0\nG1 X1\n")),
            "(25.4 25.4 25.4), 50.8 25.4 25.4");
  // The part's frame is the one in force at the first move.
  EXPECT_EQ(way(read("G21 G90 F100\nG92 X0 Y0 Z5\nG1 X1\n")), "1 0 5");
  EXPECT_EQ(refusal("G21 G90 F100\nG92 X0 Y0 Z5\nG1 X1\nG92.1\n"),
            "line 4, column 1: the part's frame is that of G92: where the one without "
            "is, is unknown");
  EXPECT_EQ(refusal("G21 G90 F100\nG92 X0 Y0 Z5\nG92.1\nG1 X1\n"),
            "line 4, column 1: G1 from an unknown position: X is not set");
  EXPECT_EQ(refusal("G21 G90\nG0 X0\nG92 Y0"),
            "line 3, column 5: G92 at an unknown position");
  EXPECT_EQ(way(read(head + "G92 X10\nG92.2\nG92.2\nG92.3\nG1 X12\n")),
            "(1 2 3), 3 2 3");
  EXPECT_REFUSED("G92.3", "line 3, column 1: G92.3 without a G92.2");
  EXPECT_REFUSED("G92", "line 3, column 1: G92 without X, Y or Z");
  EXPECT_REFUSED("G1 G92 X0", "line 3, column 4: G92 beside G1");
}

TEST(GCodeReader, InverseTime)
{
  const auto p = read("G21 G90 F100\nG0 X0 Y0 Z5\nG93 G1 X3 Y4 F2\nX3 F9\n"
                      "G2 X13 I5 F3\nG94 G1 X0 F100\n");
  // 5 mm in half a minute; nowhere needs no move; half a circle in a third.
  EXPECT_DOUBLE_EQ(p.moves[1].feed, 10.0);
  EXPECT_NEAR(p.moves[2].feed, 3 * pi * 5, 1e-9);
  EXPECT_EQ(p.moves[2].line, 5u);
  EXPECT_EQ(p.moves.back().feed, 100.0);
  EXPECT_REFUSED("G93 G1 X1", "line 3, column 5: G1 in inverse time, G93, without F");
  EXPECT_REFUSED("G93 G1 X1 F1\nX2", "line 4, column 1: G1 in inverse time");
  EXPECT_REFUSED("G93 G1 X1 F1\nG94 X2", "line 4, column 5: G1 without a feed");
  // A helix counts by its length.
  const auto helix = read("G20 G90\nG0 X0 Y0 Z0\nG93 G3 X0 Y0 I1 Z2 F1\n");
  EXPECT_NEAR(helix.moves.back().feed, 25.4 * std::hypot(2 * pi, 2), 1e-9);
}

TEST(GCodeReader, AbsoluteCentres)
{
  const auto half = arc("G90.1 G2 X10 Y0 I5 J0", 0, 0);
  EXPECT_LT(deviation(half, {5, 0}, 5), 1.0001e-4);
  EXPECT_EQ(arc("G90.1 G2 X10 Y0 I5 J0\nG91.1 G2 X20 I5", 0, 0).moves.back().to,
            Eigen::Vector3d(20, 0, 5));
  EXPECT_REFUSED("G90.1 G2 X10 I5", "line 3, column 7: an arc in G90.1 without J");
}

TEST(GCodeReader, WorkOffsets)
{
  for (const char* const offset :
       {"G54", "G55", "G59", "G59.3", "G54.1 P12", "G154 P99"})
    EXPECT_EQ(
        way(read(std::string("G21 ") + offset + "\nG0 X1 Y2 Z3\n" + offset + "\nX2\n")),
        "(1 2 3), (2 2 3)")
        << offset;
  // Without a move they change nothing.
  EXPECT_EQ(way(read("G21 G54\nG53 G0 Z0\nG55\nG0 X1\n")), "(? ? inf), (1 ? inf)");
  EXPECT_EQ(way(read("G21 G55\nG0 X1\nG54\nG53 Z0\nG55 X2\n")),
            "(1 ? ?), (1 ? inf), (2 ? inf)");
  EXPECT_REFUSED("G54.1 P1 Z4",
                 "line 3, column 10: a position in G54.1 P1 after those in G54");
  EXPECT_REFUSED("G54.1", "line 3, column 1: G54.1 needs P");
  EXPECT_REFUSED("G154 P0", "line 3, column 6: P must be a whole number, 1 .. 300");
}

TEST(GCodeReader, WhatTheMachineDecidesIsNotStated)
{
  const std::string head = "G21 G90 F100\nG0 X0 Y0 Z5\n";
  EXPECT_EQ(read(head + "G61\nG1 X1\n").blend, 0);
  EXPECT_EQ(read(head + "G1 X1\nG61\nG1 X2\n").blend, -1);
  EXPECT_EQ(read(head + "G187 P3 E0.05\nG1 X1\nG187\n").blend, 0.05);
  EXPECT_EQ(read(head + "G187 P3 E0.05\nG1 X1\nG187\nX2\n").blend, -1);
  EXPECT_EQ(read(head + "G187 P3\nG1 X1\n").blend, -1);
  EXPECT_EQ(read(head + "G61\nG5.1 Q1\nG1 X1\nG05.1 Q0\n").blend, -1);
  EXPECT_EQ(read("G20 G90 F9\nG0 X0 Y0 Z5\nG187 E0.001\nG1 X1\n").blend, 0.0254);
  EXPECT_REFUSED("G187 E-1", "line 3, column 6: E must not be negative");
  EXPECT_REFUSED("G5.1", "line 3, column 1: G5.1 (spline)");
  EXPECT_REFUSED("G5.1 X1 Q1", "line 3, column 1: G5.1 (spline)");
}

TEST(GCodeReader, NumbersOfProgramsAndBlocks)
{
  const auto p = read("%\nO1001 (PART)\nN10 G21 G90\nN20 G00 X1 Y2 Z3\n"
                      "N30 (A COMMENT)\nN40\nN10 M30\n%\n");
  EXPECT_EQ(p.moves.size(), 1u);
  EXPECT_TRUE(p.ended);
  EXPECT_EQ(read("O01001 (haas) G21\nG0 X1\n").moves.size(), 1u);
  EXPECT_REFUSED("O2", "line 3, column 1: O (subprogram)");
  EXPECT_REFUSED("O2 if [1]", "line 3, column 1: O (subroutine or program number)");
  EXPECT_REFUSED("O<name> sub", "line 3, column 1: O (subroutine or program number)");
  EXPECT_REFUSED("N-1", "line 3, column 1: N must not be negative");
}

TEST(GCodeReader, AToolThatIsMountedAlready)
{
  std::istringstream in("G21 G90 F100\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z0\n");
  pointmill::GCodeReader reader;
  reader.setMountedTool(4);
  const auto p = reader.read(in);
  EXPECT_EQ(p.moves.back().tool, 4);
  EXPECT_TRUE(p.moves.back().length_offset);
  EXPECT_TRUE(p.tools.empty());
  EXPECT_FALSE(read("G21 G90 F100\nG0 X0 Y0 Z5\nG1 Z0\n").moves.back().length_offset);
}
