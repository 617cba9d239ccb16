// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The written programs and hand-made arcs, judged by LinuxCNC's own interpreter.
#include "sample.h"

#include <pointmill/gcode/gcode_reader.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

struct Call {
  bool rapid = false;
  Eigen::Vector3d to;
};

/// What LinuxCNC would have made the machine do.
struct Judgement {
  int status = -1;
  std::string text, errors;
  std::vector<Call> moves;
  std::vector<int> tools;
};

std::string contents(const fs::path& path)
{
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Judgement judge(const std::string& program)
{
  std::string name = (fs::temp_directory_path() / "pointmill-XXXXXX").string();
  const char* const made = mkdtemp(name.data());
  if (!made)
    throw std::runtime_error("no temporary directory");
  const fs::path folder = made;
  std::ofstream(folder / "program.ngc") << program;
  std::ofstream(folder / "parameters") << "5161\t0.000000\n";
  std::ofstream tools(folder / "tool.tbl");
  for (int t = 1; t <= 9; ++t)
    tools << "T" << t << " P" << t << " Z0 D10\n";
  tools.close();

  Judgement result;
  const std::string command = "cd '" + folder.string() +
                              "' && HOME=$PWD timeout 60 rs274 -g -n 2 -t tool.tbl "
                              "-v parameters program.ngc out </dev/null >log 2>&1";
  result.status = std::system(command.c_str());
  result.text = contents(folder / "out");
  result.errors = contents(folder / "log");
  fs::remove_all(folder);

  std::istringstream lines(result.text);
  std::string line;
  while (std::getline(lines, line)) {
    const auto open = line.find('(');
    const auto call = line.substr(0, open);
    double n[6] = {};
    if (open == std::string::npos)
      continue;
    const int count = std::sscanf(line.c_str() + open,
                                  "(%lf, %lf, %lf, %lf, %lf, %lf",
                                  n,
                                  n + 1,
                                  n + 2,
                                  n + 3,
                                  n + 4,
                                  n + 5);
    const auto is = [&call](const std::string& what) {
      return call.size() > what.size() &&
             call.compare(call.size() - what.size() - 1, what.size() + 1, " " + what) ==
                 0;
    };
    if (is("STRAIGHT_FEED") || is("STRAIGHT_TRAVERSE"))
      result.moves.push_back({is("STRAIGHT_TRAVERSE"), {n[0], n[1], n[2]}});
    else if (is("ARC_FEED") && count >= 6)
      // XY plane only: end x, end y, centre x, centre y, turns, end z.
      result.moves.push_back({false, {n[0], n[1], n[5]}});
    else if (is("SELECT_TOOL"))
      result.tools.push_back(static_cast<int>(n[0]));
  }
  return result;
}

bool installed()
{
  return std::system("command -v rs274 >/dev/null 2>&1") == 0;
}

/// Every move's end, one for each line of the program (an arc's chords are one move).
void expectSameMoves(const pointmill::Program& program, const Judgement& judgement)
{
  std::size_t j = 0;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const auto& move = program.moves[i];
    if (i + 1 < program.moves.size() && program.moves[i + 1].line == move.line)
      continue;
    ASSERT_LT(j, judgement.moves.size());
    const auto& call = judgement.moves[j++];
    ASSERT_EQ(call.rapid, move.rapid) << "line " << move.line;
    for (int axis = 0; axis < 3; ++axis)
      if (std::isfinite(move.to[axis])) {
        ASSERT_NEAR(call.to[axis], move.to[axis], 1e-4) << "line " << move.line;
      }
  }
  EXPECT_EQ(j, judgement.moves.size());
  EXPECT_EQ(program.tools, judgement.tools);
}

#define NEED_LINUXCNC()                                                                \
  if (!installed())                                                                    \
  GTEST_SKIP() << "rs274 (linuxcnc-uspace) is not installed"

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
  const std::string text = "%\n"
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
                           "x-1e\n";
  // Both refuse the last line; without it both go the same way.
  EXPECT_NE(judge(text).status, 0);
  std::istringstream bad(text);
  EXPECT_THROW(pointmill::readProgram(bad), std::exception);

  const std::string good = text.substr(0, text.rfind("x-1e")) + "g1 x-1\nm2\n%\n";
  const auto judgement = judge(good);
  ASSERT_EQ(judgement.status, 0) << judgement.errors;
  std::istringstream in(good);
  expectSameMoves(pointmill::readProgram(in), judgement);
}

TEST(LinuxCnc, ReadsInchesAsTheReaderDoes)
{
  NEED_LINUXCNC();
  const std::string head = "G17 G90 G94\nT1 M6\nG43 H1\nG20\n";
  const std::string body = "G0 Z1\nX1 Y2\nG1 Z-.5 F20\nX1.125\nG2 X2.125 I.5\nM2\n";
  const auto judgement = judge(head + body);
  ASSERT_EQ(judgement.status, 0) << judgement.errors;
  std::istringstream in(head + body);
  const auto program = pointmill::readProgram(in);
  ASSERT_TRUE(program.inches);
  ASSERT_FALSE(judgement.moves.empty());
  // Canonical positions are in the program's unit, our moves in mm.
  EXPECT_NEAR(judgement.moves.back().to.x() * 25.4, program.moves.back().to.x(), 3e-3);
  EXPECT_DOUBLE_EQ(program.moves.back().to.x(), 2.125 * 25.4);
  EXPECT_DOUBLE_EQ(program.moves.back().feed, 20 * 25.4);
}
