// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "sample.h"

#include <pointmill/common/error.h>
#include <pointmill/common/version.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <functional>
#include <limits>
#include <locale>

using pointmill::DataError;
using pointmill::GCodeWriter;
using pointmill::Motion;
using pointmill::Operation;
using pointmill::ParameterError;
using pointmill::Tool;
using sample::at;

namespace {

std::string refusal(const std::vector<Operation>& operations, double clearance = 10)
{
  std::ostringstream out;
  GCodeWriter writer;
  writer.setClearancePlane(clearance);
  try {
    writer.write(operations, out);
  }
  catch (const pointmill::Error& error) {
    EXPECT_EQ(out.str(), "") << "nothing may be written before a refusal";
    return error.what();
  }
  return "accepted";
}

std::string refusalOf(const std::function<void(Operation&)>& change)
{
  // The fault is in the second operation: the first one is sound.
  std::vector<Operation> list{sample::small(1), sample::small(2)};
  change(list[1]);
  return refusal(list);
}

#define EXPECT_HAS(text, part)                                                         \
  EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

} // namespace

TEST(GCodeWriter, WritesExactlyThis)
{
  auto finish = sample::small(2);
  finish.name = "Finish";
  finish.tool = Tool::ball(2, 4.5);
  finish.cutting.spindle = 18000;
  finish.cutting.coolant = false;
  finish.path.clear();
  finish.path.push_back(at(-3, 2, 12, Motion::Rapid));
  finish.path.push_back(at(-3, 2, 0.25, Motion::Plunge, 150.5f));
  finish.path.push_back(at(-3, 2, 0.25, Motion::Cut, 600));
  finish.path.push_back(at(-3, 4.00004, 0.25001, Motion::Cut, 600));
  finish.path.push_back(at(-2.5, 4, 0.2501, Motion::Link, 900));
  finish.path.push_back(at(-2.5, 4, 12, Motion::Retract));
  auto again = sample::small(2);
  again.name = "Again";
  again.tool = finish.tool;
  again.cutting = finish.cutting;
  again.cutting.spindle = 15000;
  again.cutting.coolant = true;

  GCodeWriter writer;
  writer.setClearancePlane(10);
  writer.addComment("Bracket (left), 3rd try");
  writer.setPathTolerance(0.02);
  std::ostringstream out;
  const auto statistics = writer.write({sample::small(), finish, again}, out);
  const std::string expected = std::string("(PointMill ") + pointmill::version +
                               " for LinuxCNC)\n"
                               "(Bracket [left], 3rd try)\n"
                               "(T1 flat 10 mm)\n"
                               "(T2 ball 4.5 mm)\n"
                               "G17 G21 G40 G49 G54 G80 G90 G94\n"
                               "G91.1\n"
                               "G64 P0.02 Q0.\n"
                               "(Operation 1: Rough)\n"
                               "M5 M9\n"
                               "G53 G0 Z0.\n"
                               "T1 M6\n"
                               "G43 H1\n"
                               "S10000 M3\n"
                               "M8\n"
                               "G0 Z10.\n"
                               "G0 X0. Y0.\n"
                               "Z1.\n"
                               "G1 Z-1.5 F300.\n"
                               "X20. F1000.\n"
                               "Y20.25\n"
                               "G0 Z10.\n"
                               "(Operation 2: Finish)\n"
                               "M5 M9\n"
                               "G53 G0 Z0.\n"
                               "T2 M6\n"
                               "G43 H2\n"
                               "S18000 M3\n"
                               "G0 Z12.\n"
                               "G0 X-3. Y2.\n"
                               "G1 Z0.25 F150.5\n"
                               "Y4. Z0.2501 F600.\n"
                               "X-2.5 F900.\n"
                               "G0 Z12.\n"
                               "(Operation 3: Again)\n"
                               "S15000 M3\n"
                               "M8\n"
                               "X0. Y0.\n"
                               "Z10.\n"
                               "Z1.\n"
                               "G1 Z-1.5 F300.\n"
                               "X20. F1000.\n"
                               "Y20.25\n"
                               "G0 Z10.\n"
                               "M5 M9\n"
                               "G53 G0 Z0.\n"
                               "M30\n";
  EXPECT_EQ(out.str(), expected);
  EXPECT_EQ(statistics.bytes, expected.size());
  EXPECT_EQ(
      statistics.lines,
      static_cast<std::size_t>(std::count(expected.begin(), expected.end(), '\n')));
  EXPECT_EQ(statistics.feed_moves, 3u + 3u + 3u);
  EXPECT_EQ(statistics.rapids, 5u + 4u + 4u + 1u);
  EXPECT_EQ(statistics.tool_changes, 2u);
  EXPECT_EQ(statistics.skipped, 1u);
}

TEST(GCodeWriter, TheSameBytesWheneverAndWherever)
{
  const auto program = sample::random(2000, 2, 7);
  const auto text = sample::write(program, 12.5);
  EXPECT_EQ(sample::write(program, 12.5), text);

  // Not every machine has German installed: this one is made of a comma and points.
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new Comma));
  const char* const german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const auto local = sample::write(program, 12.5);
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(local, text) << (german ? "de_DE" : "own locale only");
}

TEST(GCodeWriter, ZeroToleranceIsExactPath)
{
  GCodeWriter writer;
  writer.setClearancePlane(10);
  for (const double tolerance : {0.0, 1e-9}) {
    writer.setPathTolerance(tolerance);
    std::ostringstream out;
    writer.write({sample::small()}, out);
    EXPECT_HAS(out.str(), "\nG61\n");
    EXPECT_EQ(out.str().find("G64"), std::string::npos);
  }
}

TEST(GCodeWriter, CommentsAreHarmless)
{
  auto op = sample::small();
  op.name = "Fr\xC3\xA4sen (1)\nM30";
  GCodeWriter writer;
  writer.setClearancePlane(10);
  writer.addComment("MSG, stop here");
  writer.addComment("log open,x\ttab\x01");
  writer.addComment(std::string(200, 'x') + " " + std::string(30, 'y') + " end");
  writer.addComment("");
  std::ostringstream out;
  writer.write({op}, out);
  std::istringstream in(out.str());
  std::string line;
  int comments = 0;
  while (std::getline(in, line)) {
    EXPECT_LE(line.size(), 80u);
    for (const char c : line)
      EXPECT_TRUE(c >= ' ' && c <= '~') << line;
    if (line[0] != '(')
      continue;
    ++comments;
    EXPECT_EQ(line.find_first_of("()", 1), line.size() - 1) << line;
  }
  EXPECT_EQ(comments, 1 + 1 + 1 + 4 + 1 + 2);
  EXPECT_HAS(out.str(), "\n(MSG: stop here)\n");
  EXPECT_HAS(out.str(), "\n(log open:x tab)\n");
  EXPECT_HAS(out.str(), "\n(Operation 1: Fr_sen [1])\n(M30)\n");
}

TEST(GCodeWriter, TravelsAtTheHigherOfBothEnds)
{
  auto first = sample::small(), second = sample::small();
  second.path[0].z = 15;
  const auto text = sample::write({first, second}, 10);
  EXPECT_HAS(text, "(Operation 2: Rough)\nZ15.\nX0. Y0.\nZ1.\n");
}

TEST(GCodeWriter, TheClearancePlaneIsComparedAsPrinted)
{
  // 5.3f lies above 5.3 and 5.1f below 5.1.
  for (const double plane : {5.3, 5.1, -0.7, 33.3}) {
    auto op = sample::small();
    for (auto& p : op.path)
      p.z = static_cast<float>(plane);
    EXPECT_NO_THROW(sample::write({op}, plane)) << plane;
  }
}

TEST(GCodeWriter, RefusesSettings)
{
  std::ostringstream out;
  GCodeWriter writer;
  const std::vector<Operation> one{sample::small()};
  EXPECT_THROW(writer.write(one, out), ParameterError) << "no clearance plane";
  writer.setClearancePlane(10);
  EXPECT_NO_THROW(writer.write(one, out));
  for (const double bad : {-0.01, 1.5, std::nan("")}) {
    writer.setPathTolerance(bad);
    EXPECT_THROW(writer.write(one, out), ParameterError);
  }
  writer.setPathTolerance(0);
  for (const int bad : {2, 7}) {
    writer.setDecimals(bad);
    EXPECT_THROW(writer.write(one, out), ParameterError);
  }
}

TEST(GCodeWriter, RefusesOperations)
{
  EXPECT_HAS(refusal({}), "no operations");
  EXPECT_EQ(refusalOf([](Operation&) {}), "accepted");
  EXPECT_HAS(refusalOf([](Operation& op) { op.path.clear(); }),
             "operation 2 'Rough': its path is empty");
  for (const double bad : {0.0, -1.0, std::nan("")})
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.cutting.spindle = bad; }),
               "spindle");
  EXPECT_HAS(refusalOf([](Operation& op) { op.tool.diameter = 0; }), "diameter");
  EXPECT_HAS(refusalOf([](Operation& op) { op.tool = Tool::ball(1, 10); }),
             "T1 ball 10 mm and T1 flat 10 mm differ but share one number");
  EXPECT_EQ(refusalOf([](Operation& op) { op.tool = Tool::flat(1, 10); }), "accepted");
}

TEST(GCodeWriter, RefusesPoints)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float inf = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, inf, -inf, 100001.f, -100001.f}) {
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.path[3].x = bad; }),
               "point 3: a coo");
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.path[3].y = bad; }),
               "point 3: a coo");
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.path[3].z = bad; }),
               "point 3: a coo");
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.path[0].z = bad; }),
               "point 0: a coo");
  }
  for (const float bad : {0.f, -1.f, 1e-4f, 2e6f, nan, inf})
    EXPECT_HAS(refusalOf([bad](Operation& op) { op.path[4].feed = bad; }),
               "point 4: feed");
  EXPECT_HAS(refusalOf([](Operation& op) { op.path[2].motion = 8; }),
             "point 2: its mot");
}

TEST(GCodeWriter, RefusesPathsBelowTheClearancePlane)
{
  EXPECT_HAS(refusalOf([](Operation& op) { op.path.front().z = 9.999f; }),
             "point 0: the path begins below the clearance plane");
  EXPECT_HAS(refusalOf([](Operation& op) { op.path.back().z = 9.999f; }),
             "point 5: the path ends below the clearance plane");
}

TEST(GCodeWriter, RefusesRapids)
{
  for (const auto how : {Motion::Rapid, Motion::Retract}) {
    EXPECT_HAS(refusalOf([how](Operation& op) { op.path[3].setMotion(how); }),
               "point 3: a rapid moves sideways below the clearance plane");
    EXPECT_HAS(refusalOf([how](Operation& op) {
                 op.path[5].setMotion(how);
                 op.path[5].x += 0.001f;
               }),
               "point 5: a rapid moves sideways and in Z at once");
  }
  // Noise below the last decimal is no sideways move.
  EXPECT_EQ(refusalOf([](Operation& op) { op.path[5].x += 0.00001f; }), "accepted");
}

TEST(GCodeWriter, LowRapidsMustBeAllowed)
{
  Operation operation = sample::small();
  auto& path = operation.path;
  path[3].setMotion(Motion::Rapid);
  path[3].z = path[2].z; // level
  const auto write = [&](bool allowed) {
    GCodeWriter writer;
    writer.setClearancePlane(10);
    writer.setLowRapids(allowed);
    std::ostringstream out;
    writer.write({operation}, out);
    return out.str();
  };
  EXPECT_THROW(write(false), pointmill::DataError);
  EXPECT_FALSE(write(true).empty());
  path[3].z += 0.5f;
  EXPECT_THROW(write(true), pointmill::DataError) << "slanted";
}

TEST(GCodeWriter, TellsWhenTheOutputFails)
{
  GCodeWriter writer;
  writer.setClearancePlane(10);
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(writer.write({sample::small()}, out), pointmill::Error);
}
