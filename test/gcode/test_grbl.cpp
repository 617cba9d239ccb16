// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What Grbl refuses, and that nothing of it is written.
#include "grbl_rules.h"
#include "two_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using pointmill::ArcPlane;
using pointmill::Post;
using pointmill::ToolChange;
using pointmill::Unit;

namespace {

const std::string head = "G17 G21 G54 G90 G94\nG91.1\nT1\nS9000 M3\nG0 Z10.\n";

std::string faultOf(const std::string& lines)
{
  return GrblRules::fault(head + lines + "\nM30\n");
}

struct Bad {
  const char* lines;
  const char* fault;
};

class GrblRefuses : public testing::TestWithParam<Bad> {};

/// Random arcs and helices in all planes, one after the other.
class RandomArcs : public pointmill::CallAdapter {
public:
  explicit RandomArcs(pointmill::MachineCalls& next) : CallAdapter(next) {}
  void approach(const pointmill::MachinePosition& to) override
  {
    CallAdapter::approach(at_ = to);
  }
  void traverse(const pointmill::MachinePosition& to) override
  {
    CallAdapter::traverse(at_ = to);
  }
  void straight(const pointmill::MachinePosition& to, std::int64_t feed) override
  {
    CallAdapter::straight(at_ = to, feed);
    std::uniform_int_distribution<std::int64_t> offset(-90000, 90000);
    for (int i = 0; i < 3; ++i) {
      pointmill::MachineArc arc;
      arc.plane = ArcPlane(i);
      arc.clockwise = offset(engine_) > 0;
      arc.u = offset(engine_);
      arc.v = offset(engine_);
      arc.to = at_; // a full turn, and with i > 0 a helix
      (i == 0 ? arc.to.z : i == 1 ? arc.to.y : arc.to.x) += 100 * i;
      CallAdapter::arc(arc, feed);
      at_ = arc.to;
    }
    CallAdapter::straight(at_ = to, feed);
  }

private:
  std::mt19937 engine_{3};
  pointmill::MachinePosition at_;
};

} // namespace

TEST(GrblRules, TakeAGoodProgram)
{
  EXPECT_EQ(faultOf("G0 X0 Y0\nG1 Z-1 F100\nG2 X10 I5\nG3 X0 Z-2 I-5 (a helix)\n"
                    "G18\nG2 X10 K0 I5\nG19\nG3 Y10 J5\nG4 P0.5\nG53 G0 Z0\n"
                    "G28 G91 Z0\nG90\nM5 M9 ; off"),
            "");
}

TEST_P(GrblRefuses, ABadProgram)
{
  const auto fault = faultOf(GetParam().lines);
  EXPECT_NE(fault.find(GetParam().fault), std::string::npos) << fault;
}

INSTANTIATE_TEST_SUITE_P(
    GrblRules,
    GrblRefuses,
    testing::Values(Bad{"%", "error 1"},
                    Bad{"(a (b) c)", "error 1"},
                    Bad{"(open", "error 1"},
                    Bad{"O1001", "error 20"},
                    Bad{"X#1", "error 2"},
                    Bad{"X[1+2]", "error 2"},
                    Bad{"G1 X1.2.3 F100", "error 2"},
                    Bad{"G1 X1e3 F100", "error"},
                    Bad{"G1 F-100 X1", "error 4"},
                    Bad{"G1 F100 X100000.0000 Y100000.0000 Z100000.0000 "
                        "(not counted) N1000000 S1000000.0000000000000000000000",
                        "error 11"},
                    Bad{"M6", "error 20"},
                    Bad{"M7", "error 20"},
                    Bad{"G43 H1", "error 20"},
                    Bad{"G64 P0.1", "error 20"},
                    Bad{"G61.1", "error 20"},
                    Bad{"G81 Z-1 R1", "error 20"},
                    Bad{"G90.1", "error 20"},
                    Bad{"G95", "error 20"},
                    Bad{"G59.1", "error 20"},
                    Bad{"H1", "error 20"},
                    Bad{"G0 G1 X1 F100", "error 21"},
                    Bad{"G17 G18", "error 21"},
                    Bad{"G20 G21", "error 21"},
                    Bad{"G90 G91", "error 21"},
                    Bad{"G54 G55", "error 21"},
                    Bad{"G28 G53 X0", "error 21"},
                    Bad{"M3 M5", "error 21"},
                    Bad{"M8 M9", "error 21"},
                    Bad{"G1 X1", "error 22"},
                    Bad{"M3.5", "error 23"},
                    Bad{"G0 G28 Z0", "error 24"},
                    Bad{"G0 X1 X2", "error 25"},
                    Bad{"G2 F100", "error 26"},
                    Bad{"N10000001 G0 X1", "error 27"},
                    Bad{"G4", "error 28"},
                    Bad{"G1 F100 X0\nG2 X10 I5\nG53 Z0", "error 30"},
                    Bad{"G80\nX1", "error 31"},
                    Bad{"F100 G0 X0 Y0\nG2 Z1 I5", "error 32"},
                    Bad{"F100 G0 X0 Y0\nG2 I5", "error 26"},
                    Bad{"F100 G0 X0 Y0\nG2 X10 I5.01", "error 33"},
                    Bad{"F100 G0 X0 Y0\nG2 X1000 I500.6", "error 33"},
                    Bad{"F100 G0 X0 Y0\nG2 X0 Y0 R5", "error 33"},
                    Bad{"F100 G0 X0 Y0\nG2 X10 R4", "error 34"},
                    Bad{"F100 G0 X0 Y0\nG2 X10", "error 35"},
                    Bad{"G0 X1 P5", "error 36"},
                    Bad{"G1 F100 X1 I5", "error 36"},
                    Bad{"T256", "error 38"},
                    Bad{"(really?)", "real-time"},
                    Bad{"(50 \xC2\xB5m)", "real-time"},
                    Bad{"M30\nG0 X0", "follows the end"}));

TEST(GrblRules, AProgramMustEnd)
{
  EXPECT_NE(GrblRules::fault(head), "");
}

TEST(GrblRules, AllowAnArcWhatGrblDoes)
{
  // 0.004 mm is little, 0.4 mm is little of 500.
  EXPECT_EQ(faultOf("F100 G0 X0 Y0\nG2 X1 I0.502"), "");
  EXPECT_EQ(faultOf("F100 G0 X0 Y0\nG2 X1000 I500.2"), "");
}

TEST(Grbl, TakesAllThatIsWritten)
{
  for (const auto unit : {Unit::Millimetre, Unit::Inch})
    for (const bool numbers : {false, true})
      for (const auto tools : {ToolChange::Program, ToolChange::Pause})
        for (const auto retract : {pointmill::Retract::Clearance,
                                   pointmill::Retract::Machine,
                                   pointmill::Retract::Home}) {
          auto writer = sample::plainWriterFor(Post::named("grbl"), unit);
          writer.setClearancePlane(12.5);
          writer.setLineNumbers(numbers);
          writer.setToolChange(tools);
          writer.setRetract(retract);
          writer.addComment("Really? (100 %) ~ done! \xC3\xA4 \x18 {1}");
          writer.addComment(std::string(300, 'x'));
          writer.addAdapter([](pointmill::MachineCalls& next) {
            return std::make_unique<RandomArcs>(next);
          });
          auto operations = sample::random(600, 2, 5);
          operations[0].name = "Will it? (yes)";
          for (const auto& [suffix, text] : sample::files(writer, operations))
            EXPECT_EQ(GrblRules::fault(text.str()), "") << suffix;
        }
}

TEST(Grbl, WaitsForTheSecondToolWhereItIsToldTo)
{
  auto writer = sample::writerFor(Post::named("grbl"));
  writer.setToolChange(ToolChange::Pause);
  auto files = sample::files(writer, sample::twoTools());
  ASSERT_EQ(files.size(), 1u);
  const std::string text = files[""].str();
  EXPECT_EQ(text.find("M0\n"), text.rfind("M0\n"));
  EXPECT_NE(text.find("(Operation 2: Finish)\n"
                      "M5 M9\n"
                      "(Change to T2 ball 4.5 mm and set its length)\n"
                      "T2\n"
                      "M0\n"
                      "S18000 M3\n"
                      "G0 Z12.\n"
                      "G0 X-3. Y2.\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(GrblRules::fault(text), "");
}

TEST(Grbl, ALongNameOfAToolIsWrapped)
{
  auto operations = sample::twoTools();
  operations[1].tool = pointmill::Tool::taperBull(123, 1.2345, 0.4321, 12.345, 6.789);
  auto writer = sample::writerFor(Post::named("grbl"));
  writer.setToolChange(ToolChange::Pause);
  const std::string text = sample::files(writer, operations)[""].str();
  EXPECT_NE(text.find("\n(Change to " + operations[1].tool.describe().substr(0, 20)),
            std::string::npos)
      << text;
  EXPECT_EQ(GrblRules::fault(text), "");
}
