// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The written programs and those of others, judged by LinuxCNC's own interpreter.
#include "linuxcnc.h"
#include "random_program.h"
#include "reading.h"
#include "sample.h"

namespace {

using linuxcnc::Call;
using linuxcnc::judge;
using linuxcnc::Judgement;
using pointmill::ProgramMove;
using reading::read;
using reading::refusal;

const double pi = std::acos(-1.0);

/// The chords @p first .. @p last are on the interpreter's arc and go its way round.
void expectOnArc(const std::vector<ProgramMove>& moves,
                 std::size_t first,
                 std::size_t last,
                 const Call& arc)
{
  const auto arm = [&](const Eigen::Vector3d& p) -> Eigen::Vector2d {
    return Eigen::Vector2d(p[arc.u], p[arc.v]) - arc.centre;
  };
  const Eigen::Vector2d start = arm(moves[first].from), end = arm(arc.to);
  double expected =
      std::atan2(start.x() * end.y() - start.y() * end.x(), start.dot(end)) *
      (arc.clockwise ? -1 : 1);
  const double noise = 20 * arc.rounding / start.norm() + 1e-4;
  if (expected < noise)
    expected += 2 * pi;
  double turned = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const Eigen::Vector2d a = arm(moves[i].from), b = arm(moves[i].to);
    turned +=
        std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * (arc.clockwise ? -1 : 1);
    ASSERT_NEAR(b.norm(), start.norm(), 1e-4 + 4 * arc.rounding)
        << "line " << moves[i].line;
    const double rise = arc.to[arc.w] - moves[first].from[arc.w];
    ASSERT_NEAR(moves[i].to[arc.w],
                moves[first].from[arc.w] + rise * turned / expected,
                1e-4 + 4 * arc.rounding + std::abs(rise) * noise)
        << "line " << moves[i].line;
  }
  EXPECT_NEAR(turned, expected, noise) << "line " << moves[first].line;
}

void expectSameEnd(const ProgramMove& move, const Call& call)
{
  ASSERT_EQ(call.rapid, move.rapid) << "line " << move.line;
  for (int axis = 0; axis < 3; ++axis)
    if (std::isfinite(move.to[axis])) {
      ASSERT_NEAR(call.to[axis], move.to[axis], std::max(1e-4, 2 * call.rounding))
          << "line " << move.line << ", axis " << axis;
    }
  if (!move.rapid) {
    ASSERT_NEAR(call.feed, move.feed, 2 * call.rounding + 2e-5 * move.feed)
        << "line " << move.line;
  }
}

/// Every motion, with what an arc goes through, its feed and its tool.
void expectSameMoves(const pointmill::Program& program, const Judgement& judgement)
{
  const auto& moves = program.moves;
  std::size_t next = 0;
  for (std::size_t c = 0; c < judgement.calls.size(); ++c) {
    const Call& call = judgement.calls[c];
    ASSERT_LT(next, moves.size());
    // A way home over where the tool is already is one move to the reader, and going
    // nowhere in inverse time, which has no feed, is none.
    const bool home = !moves[next].to.allFinite() && moves[next].from.allFinite();
    const bool stays =
        c > 0 && (call.to - judgement.calls[c - 1].to).norm() < 4 * call.rounding;
    const bool so_does_it = (moves[next].to - moves[next].from).norm() < 1e-9;
    if (stays && !call.arc && (call.rapid ? home : !so_does_it))
      continue;
    std::size_t last = next;
    if (call.arc)
      while (last + 1 < moves.size() && moves[last + 1].line == moves[next].line)
        ++last;
    expectSameEnd(moves[last], call);
    if (call.arc)
      expectOnArc(moves, next, last, call);
    if (testing::Test::HasFatalFailure())
      return;
    next = last + 1;
  }
  EXPECT_EQ(next, moves.size());
  EXPECT_EQ(program.tools, judgement.tools);
}

void expectSameMoves(const std::string& text)
{
  const auto judgement = judge(text);
  ASSERT_EQ(judgement.status, 0) << judgement.errors;
  ASSERT_FALSE(judgement.calls.empty());
  expectSameMoves(read(text), judgement);
}

/// @p block in line 5, where everything is set.
std::string inProgram(const std::string& block)
{
  return "%\nG21 G90 G94 G17 F100\nG0 X0 Y0 Z5\nG1 Z4\n" + block + "\n%\n";
}

struct Case {
  const char* block;
  const char* refusal; ///< how it begins, behind "line 5, "
};

} // namespace

TEST(LinuxCnc, AcceptsAWrittenProgramAndGoesWhereTheReaderSays)
{
  NEED_LINUXCNC();
  pointmill::GCodeWriter writer;
  writer.setClearancePlane(12.5);
  writer.addComment("MSG, ; nothing % here ! ? ~ [is] # obeyed");
  writer.addComment("print, (logopen,file)");
  std::stringstream text;
  writer.write(sample::random(5000, 3, 11), text);
  const auto judgement = judge(text.str());
  ASSERT_EQ(judgement.status, 0) << judgement.errors;
  EXPECT_NE(judgement.text.find("USE_LENGTH_UNITS(CANON_UNITS_MM)"), std::string::npos);
  EXPECT_NE(judgement.text.find("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, 0.010000)"),
            std::string::npos);
  EXPECT_NE(judgement.text.find("SET_NAIVECAM_TOLERANCE(0.0000)"), std::string::npos);
  EXPECT_NE(judgement.text.find("PROGRAM_END()"), std::string::npos);
  EXPECT_EQ(judgement.text.find("MESSAGE"), std::string::npos);
  expectSameMoves(pointmill::readProgram(text), judgement);
}

TEST(LinuxCnc, ReadsArcsAndModesAsTheReaderDoes)
{
  NEED_LINUXCNC();
  expectSameMoves("%\n"
                  "N10 g21 g90 g17 g94 g91.1 f500 (head)\n"
                  "t2 m6\n"
                  "g43 h2 s5000 m3\n"
                  "g0 z 1 0 . 5\n"
                  "x0 y0\n"
                  "g1 z-1\n"
                  "g2 x10 y0 i5 ; half\n"
                  "g3 x20 y10 z-2 r10\n"
                  "g3 x0 y0 r-30\n"
                  "g3 i5 j5\n"
                  "g91\n"
                  "g1 x1.5 y-.5 f200.5\n"
                  "y+2\n"
                  "g2 x2 y2 i2 j0\n"
                  "g90 g0 z10\n"
                  "g4 p0.5\n"
                  "g1 x-1\nm2\n%\n");
}

TEST(LinuxCnc, ReadsArcsInAllPlanesAsTheReaderDoes)
{
  NEED_LINUXCNC();
  expectSameMoves("G21 G90 G17 G94\nT1 M6\nG43 H1\nS1000 M3\nG0 Z10\nX0 Y0\n"
                  "G18\nG1 F500 Z0\nG2 X10 Z-5 R20\nG3 X0 Z0 I-5 K2.5 Y3\n"
                  "G19 G2 Y13 Z5 J5 K2.5 X2\nG3 Y13 Z5 J-3 K0\n"
                  "G17 G90.1 G3 X10 Y5 I6 J9\nG91.1 G2 X12 Y5 I1\nM2\n");
}

TEST(LinuxCnc, ReadsFramesAndReferencePointsAsTheReaderDoes)
{
  NEED_LINUXCNC();
  expectSameMoves("G21 G90 G17 G94 F100\nT1 M6\nG43 H1\nG53 G0 Z1\nG0 Z10\nX1 Y2\n"
                  "G91\nG28 X5 Z2\nG90\nG0 X3 Z4\nG28 G91 Z0\nG90 G0 X1 Y2 Z3\n"
                  "G92 X100 Y50\nG1 X110 Y60\nG2 X120 I5\nG92.2\nG1 X5\nG92.3\n"
                  "G1 X105\nG92.1\nG1 X6\nG30 Z8\nG0 Z9\nG28\nG53 G0 Z2\nG0 Z50\nM2\n");
  for (const char* const offset :
       {"G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"})
    expectSameMoves(std::string("G21 ") + offset + "\nG0 X1 Y2 Z3\nG1 X5 F100\nM2\n");
}

TEST(LinuxCnc, ReadsInverseTimeAsTheReaderDoes)
{
  NEED_LINUXCNC();
  expectSameMoves("G21 G90 G17 G94 F100\nG0 X1 Y2 Z3\nG1 X2\nG93 G1 X10 Y5 F2\n"
                  "G2 X20 Y5 Z2 I5 F3\nG1 X21 F4\nG94 G1 X0 F100\nY1\nM2\n");
}

TEST(LinuxCnc, ReadsInchesAsTheReaderDoes)
{
  NEED_LINUXCNC();
  const std::string text = "G17 G90 G94\nT1 M6\nG43 H1\nG20\n"
                           "G0 Z1\nX1 Y2\nG1 Z-.5 F20\nX1.125\nG2 X2.125 I.5\n"
                           "G21\nG1 X50 F500\nM2\n";
  expectSameMoves(text);
  const auto program = read(text);
  EXPECT_TRUE(program.inches);
  EXPECT_DOUBLE_EQ(program.moves[3].to.x(), 1.125 * 25.4);
  EXPECT_DOUBLE_EQ(program.moves[3].feed, 20 * 25.4);
}

TEST(LinuxCnc, GoesWhereTheReaderSaysInRandomPrograms)
{
  NEED_LINUXCNC();
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectSameMoves(randomProgram(seed, 400, seed % 3 == 0));
    if (HasFatalFailure())
      return;
  }
}

TEST(LinuxCnc, RefusesWhatTheReaderRefuses)
{
  NEED_LINUXCNC();
  const Case cases[] = {
      {"X1 Y1 G2", "column 7: an arc without centre or radius"},
      {"G2 X10", "column 1: an arc without centre or radius"},
      {"G2", "column 1: G2 without its words"},
      {"G2 X10 I5 R5", "column 8: I beside R"},
      {"G2 X10 I4", "column 1: the arc's radius is 4.000000 mm at its start"},
      {"G2 X10 R4", "column 8: R is too small"},
      {"G2 X0 Y0 R5", "column 1: an arc with R must not end where it starts"},
      {"G2 X0 Y0 I0 J0", "column 1: the arc's radius is 0"},
      {"G2 X10 Y0 K5", "column 11: K does not belong to plane G17"},
      {"G18 G2 X10 Z5 J5", "column 15: J does not belong to plane G18"},
      {"G90.1 G2 X10 I5", "column 7: an arc in G90.1 without J"},
      {"G3 X10 I5 P-1", "column 11: P (turns of an arc)"},
      {"G1 X1 F0", "column 7: F must be above 0"},
      {"G1 X1 F-5", "column 7: F must be above 0"},
      {"G93 G1 X1", "column 5: G1 in inverse time, G93, without F"},
      {"G0 G1 X1", "column 4: G1 and G0: two motion words"},
      {"G17 G18", "column 5: G18 and G17: two plane words"},
      {"G20 G21", "column 5: G21 and G20: two units words"},
      {"G90 G91", "column 5: G91 and G90: two distance mode words"},
      {"G94 G93", "column 5: G93 and G94: two feed mode words"},
      {"G54 G55", "column 5: G55 and G54: two work offset words"},
      {"G61 G64", "column 5: G64 and G61: two path mode words"},
      {"M3 M4", "column 4: M4 and M3: two spindle words"},
      {"M8 M9", "column 4: M9 and M8: two coolant words"},
      {"M0 M30", "column 4: M30 and M0: two program stop words"},
      {"X1 X2", "column 4: a second X word"},
      {"G1 X1 F1 F2", "column 10: a second F word"},
      {"T1 T2", "column 4: a second T word"},
      {"X", "column 1: X has no number"},
      {"N", "column 1: N has no number"},
      {"N-5 X1", "column 1: N must not be negative"},
      {"X1 N5", "column 4: N must be the first word"},
      {"X1.2.3", "column 5: '.' is not supported"},
      {"X1e3", "column 3: E without G187"},
      {"X1 (open", "column 4: the comment is not closed"},
      {"(a (b))", "column 4: a comment inside a comment"},
      {"X1)", "column 3: ')' is not supported"},
      {"X1,Y2", "column 3: ',' is not supported"},
      {"X1 !", "column 4: '!' is not supported"},
      {"G1 X[1", "column 5: '[' (expressions)"},
      {"% X1", "column 1: '%' must stand alone"},
      {"X1 %", "column 4: '%' must stand alone"},
      {"G12.3", "column 1: G12.3 is not known"},
      {"G2.5 X1", "column 1: G2.5 is not known"},
      {"G59.4", "column 1: G59.4 is not known"},
      {"G61.2", "column 1: G61.2 is not known"},
      {"G-1", "column 1: the number after G is no code"},
      {"G1.23", "column 1: the number after G is no code"},
      {"M21", "column 1: M21 is not known"},
      {"G4", "column 1: G4 needs P"},
      {"G4 P-1", "column 1: G4 needs P"},
      {"S-5", "column 1: S must not be negative"},
      {"T-1", "column 1: T must be a whole number"},
      {"T1.5", "column 1: T must be a whole number"},
      {"T1 M6 G43 H99", "column 11: H99 is not the length of tool 1"},
      {"P1", "column 1: P without G4"},
      {"Q1", "column 1: Q without G64"},
      {"H1", "column 1: H without G43"},
      {"I5", "column 1: I without G2 or G3"},
      {"R5", "column 1: R without G2 or G3"},
      {"G1 X1 I1", "column 7: I without G2 or G3"},
      {"G53 G2 X1 I1", "column 1: G53 is supported with G0 only"},
      {"G91 G53 G0 Z0", "column 5: G53 in incremental mode"},
      {"G80 X1", "column 5: X without G0, G1, G2 or G3"},
      {"G92", "column 1: G92 without X, Y or Z"},
      {"G92 X1 G1", "column 1: G92 beside G1"},
      {"G1 G28 X1", "column 4: G28 beside G1"},
      {"G1 G30 X1", "column 4: G30 beside G1"},
      {"G40 G41", "column 5: G41 (cutter compensation)"},
      {"G5 X1 Y1", "column 1: G5 (spline)"},
      {"G33 X1", "column 1: G33 (spindle-synchronised motion)"},
      {"G73 X1", "column 1: G73 (canned drilling)"},
      {"G76 Z1", "column 1: G76 (threading)"},
      {"M98 P1", "column 1: M98 (subprogram)"},
      {"D1", "column 1: D (cutter radius)"},
      {"U1", "column 1: U (second linear axis)"}};
  for (const auto& c : cases) {
    const auto text = inProgram(c.block);
    EXPECT_NE(judge(text).status, 0) << c.block;
    EXPECT_EQ(refusal(text).rfind(std::string("line 5, ") + c.refusal, 0), 0u)
        << c.block << ": " << refusal(text);
  }
}

/// It takes these, and the reader does not: they are beyond milling in three axes, or
/// their result depends on more than the program says, or they are no sense but a slip.
TEST(LinuxCnc, TakesMoreThanTheReader)
{
  NEED_LINUXCNC();
  const Case cases[] = {
      // Slips, of which the interpreter ignores a part.
      {"X--1", "column 1: X has no number"},
      {"M6", "column 1: M6 without a T word"},
      {"G4 P1 X1", "column 7: G4 beside motion"},
      {"G53 G1", "column 1: G53 is supported with G0 only"},
      {"G93 F0 G1 X1", "column 5: F must be above 0"},
      {"G64 P-1", "column 1: G64 with a negative tolerance"},
      // What the machine does depends on its switches, tables or earlier programs.
      {"/X1", "column 1: '/' (block delete)"},
      {"G41 D1", "column 5: D (cutter radius)"},
      {"G43.1", "column 1: G43.1 (dynamic tool length)"},
      {"G92.3", "column 1: G92.3 without a G92.2"},
      {"G10 L2 P1", "column 5: L (repetition)"},
      {"G28.1", "column 1: G28.1 (setting of a reference point)"},
      {"G55 X1", "column 5: a position in G55 after those in G54"},
      {"M48", "column 1: M48 (overrides)"},
      {"M62 P1", "column 1: M62 (inputs and outputs)"},
      // Programs that compute.
      {"#1=5", "column 1: '#' (parameters)"},
      {"G1 X[1]", "column 5: '[' (expressions)"},
      {"M99", "column 1: M99 (subprogram)"},
      // Other kinds of motion.
      {"G2 X1 Y1 I0.5 J0.5 P2", "column 20: P (turns of an arc)"},
      {"G81 X1 Y1 Z1 R2", "column 1: G81 (canned drilling)"},
      {"G95", "column 1: G95 (feed per revolution)"},
      {"G38.2 Z1", "column 1: G38.2 (probing)"},
      {"G17.1", "column 1: G17.1 (second plane)"},
      {"G7", "column 1: G7 (lathe diameter mode)"},
      {"G52 X1", "column 1: G52 (local coordinate system)"},
      {"X1 A90", "column 4: A (rotary axis)"}};
  for (const auto& c : cases) {
    const auto text = inProgram(c.block);
    EXPECT_EQ(judge(text).status, 0) << c.block;
    EXPECT_EQ(refusal(text).rfind(std::string("line 5, ") + c.refusal, 0), 0u)
        << c.block << ": " << refusal(text);
  }
}

/// What other controls of this form have.
TEST(LinuxCnc, LacksWordsOfFanucAndHaas)
{
  NEED_LINUXCNC();
  for (const char* const block :
       {"G5.1 Q1", "G187 P3 E0.05", "G0 G28 Z9", "G4 X1", "G15", "G50", "G69"}) {
    EXPECT_NE(judge(inProgram(block)).status, 0) << block;
    EXPECT_EQ(refusal(inProgram(block)), "accepted") << block;
  }
}
