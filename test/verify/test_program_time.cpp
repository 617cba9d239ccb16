// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/verify/program_time.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

using namespace pointmill;

namespace {

using Eigen::Vector3d;

/// 400 mm/s2, corners left by 0.02 mm, G0 with 6 m/min.
Machine machine()
{
  Machine m;
  m.acceleration = 400;
  m.junction_deviation = 0.02;
  m.rapid_rate = 6000;
  return m;
}

/// Moves from place to place, written down one by one.
class Path {
public:
  explicit Path(const Vector3d& start = {0, 0, 0}) : at_(start) {}
  Path& feed(double x, double y, double z, double f = 1200)
  {
    return move({x, y, z}, f, false);
  }
  Path& rapid(double x, double y, double z) { return move({x, y, z}, 0, true); }
  Program program;

private:
  Path& move(const Vector3d& to, double feed, bool rapid)
  {
    ProgramMove m;
    m.from = at_;
    m.to = to;
    m.feed = feed;
    m.rapid = rapid;
    m.line = program.moves.size() + 1;
    m.tool = 1;
    program.moves.push_back(m);
    at_ = to;
    return *this;
  }
  Vector3d at_;
};

double seconds(const Program& program,
               const Machine& m = machine(),
               CornerMode corners = CornerMode::Program)
{
  return programTime(program, m, {corners}).total.total();
}

Program read(const std::string& text)
{
  std::istringstream in(text);
  return readProgram(in);
}

Path randomPath(unsigned seed, int count)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-6, 6), feed(300, 4000);
  Path path;
  for (int i = 0; i < count; ++i) {
    const double x = place(random), y = place(random), z = place(random);
    if (i % 5 == 4)
      path.rapid(x, y, z);
    else
      path.feed(x, y, z, feed(random));
  }
  return path;
}

} // namespace

TEST(ProgramTime, ALongMoveIsATrapezoid)
{
  // 20 mm/s is reached and left within 0.05 s each, over 0.5 mm each.
  EXPECT_NEAR(seconds(Path().feed(30, 40, 0).program), 50 / 20.0 + 20 / 400.0, 1e-12);
  // Lengths grow, the ramps do not.
  const double far = seconds(Path().feed(1e6, 0, 0).program);
  EXPECT_NEAR(far / (1e6 / 20.0), 1.0, 1e-5);
}

TEST(ProgramTime, AShortMoveIsATriangle)
{
  EXPECT_NEAR(
      seconds(Path().feed(0, 0, -0.25).program), 2 * std::sqrt(0.25 / 400), 1e-12);
}

TEST(ProgramTime, ARapidGoesAtTheRapidRate)
{
  const auto time = programTime(Path().rapid(120, 160, 0).program, machine()).total;
  EXPECT_NEAR(time.rapid, 200 / 100.0 + 100 / 400.0, 1e-12);
  EXPECT_NEAR(time.unhindered, 2.0, 1e-12);
  EXPECT_EQ(time.cutting, 0.0);
}

TEST(ProgramTime, ARightAngleIsPassedAtTheSpeedOfItsCircle)
{
  // The circle that leaves the corner by d has the radius d c / (1 - c), c = cos 45.
  const double c = std::sqrt(0.5), corner = std::sqrt(400 * 0.02 * c / (1 - c));
  ASSERT_LT(corner, 20);
  const double brake = (20 - corner) / 400, way = (20 * 20 - corner * corner) / 800;
  const double each = 20 / 400.0 + brake + (10 - 0.5 - way) / 20;
  EXPECT_NEAR(seconds(Path().feed(10, 0, 0).feed(10, 10, 0).program), 2 * each, 1e-12);
}

TEST(ProgramTime, TheWiderTheDeviationTheFasterTheCorner)
{
  Program program = Path().feed(10, 0, 0).feed(10, 10, 0).program;
  Machine wide = machine();
  wide.junction_deviation = 0.1;
  EXPECT_LT(seconds(program, wide), seconds(program) - 1e-3);
  // G64 P says how wide, whatever the machine's own is.
  program.blend = 0.1;
  EXPECT_DOUBLE_EQ(seconds(program, machine()), seconds(program, wide));
  EXPECT_GT(seconds(program, machine(), CornerMode::Machine), seconds(program) + 1e-3);
  // G64 alone: the circle reaches to the middle of the moves, 5 mm, at 20 mm/s.
  program.blend = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(seconds(program), 20 / 20.0 + 20 / 400.0, 1e-12);
}

TEST(ProgramTime, SplittingALineChangesNothing)
{
  const double whole = seconds(Path().feed(20, 10, -5).program);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (const CornerMode mode : {CornerMode::Program, CornerMode::ExactStop}) {
    std::vector<double> at(200);
    for (double& a : at)
      a = share(random);
    std::sort(at.begin(), at.end());
    Path path;
    for (const double a : at)
      path.feed(20 * a, 10 * a, -5 * a);
    path.feed(20, 10, -5);
    EXPECT_NEAR(seconds(path.program, machine(), mode), whole, 1e-9 * whole);
  }
  // A move that goes nowhere is no corner.
  EXPECT_EQ(seconds(Path().feed(20, 10, -5).feed(20, 10, -5).program), whole);
}

TEST(ProgramTime, AReversalIsAStop)
{
  const double there = seconds(Path().feed(10, 0, 0).program);
  Program program = Path().feed(10, 0, 0).feed(0, 0, 0).program;
  for (const double blend : {-1.0, 0.0, 0.1, std::numeric_limits<double>::infinity()}) {
    program.blend = blend;
    EXPECT_NEAR(seconds(program), 2 * there, 1e-12) << blend;
  }
}

TEST(ProgramTime, ExactStopStopsAtEveryCorner)
{
  Program program = Path().feed(10, 0, 0).feed(20, 1, 0).feed(20, 9, 0).program;
  double alone = 0;
  for (const double length : {10.0, std::hypot(10, 1), 8.0})
    alone += length / 20 + 20 / 400.0;
  EXPECT_LT(seconds(program), alone - 1e-3);
  EXPECT_NEAR(seconds(program, machine(), CornerMode::ExactStop), alone, 1e-12);
  program.blend = 0; // G61
  EXPECT_NEAR(seconds(program), alone, 1e-12);
  EXPECT_LT(seconds(program, machine(), CornerMode::Machine), alone - 1e-3);
}

TEST(ProgramTime, ACircleOfTinyChordsIsMilledAsTheCircleIs)
{
  // 10 turns with R = 2 mm at 100 mm/s: no faster than sqrt(a R) = 28.3 mm/s.
  const int turns = 10, chords = 3600;
  Path path(Vector3d(2, 0, 0));
  for (int i = 1; i <= turns * chords; ++i) {
    const double angle = 2 * M_PI * i / chords;
    path.feed(2 * std::cos(angle), 2 * std::sin(angle), 0, 6000);
  }
  const double speed = std::sqrt(400 * 2.0), length = turns * 2 * M_PI * 2;
  const double truth = length / speed + speed / 400;
  // Between two chords' corners the tool gains a little speed, the less the shorter
  // they are.
  EXPECT_NEAR(seconds(path.program) / truth, 1.0, 1e-3);
}

TEST(ProgramTime, AnArcIsNoCornerInExactPathMode)
{
  // A full circle of R = 10 mm at 1200 mm/min, its way in and out tangent to it.
  const std::string body = "G21 G17 G90 G94 G54\nT1 M6\nG43 H1\nS8000 M3\nG0 X0 Y0\n"
                           "G0 Z0\nG1 X10 F1200\nG3 X10 Y0 I0 J10\nG1 X20\nM2\n";
  const Program exact = read("G61\n" + body);
  ASSERT_EQ(exact.blend, 0.0);
  ASSERT_GT(exact.moves.size(), 100u);
  const double cutting = programTime(exact, machine()).total.cutting;
  const double length = 20 + 2 * M_PI * 10;
  // At the worst it stops where the arc begins and ends.
  EXPECT_GT(cutting, length / 20 + 20 / 400.0 - 1e-3);
  EXPECT_LT(cutting, length / 20 + 3 * 20 / 400.0 + 1e-3);
}

TEST(ProgramTime, IsThatOfTheFastestMotionWithinTheLimits)
{
  // The fastest motion has v^2(s) = min over places p of limit(p) + 2 a |s - p|, which
  // corners and the move's own feed attain. Integrated in small steps.
  const double a = 400, deviation = 0.02;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Program program = randomPath(seed, 12).program;
    const auto& moves = program.moves;
    const auto cruise = [&](std::size_t i) {
      const double v = (moves[i].rapid ? 6000 : moves[i].feed) / 60;
      return v * v;
    };
    std::vector<double> place = {0}, limit = {0};
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Vector3d way = moves[i].to - moves[i].from;
      place.push_back(place.back() + way.norm());
      if (i + 1 == moves.size())
        break;
      const Vector3d next = moves[i + 1].to - moves[i + 1].from;
      const double turn = std::acos(way.dot(next) / way.norm() / next.norm());
      const double c = std::cos(turn / 2);
      const double radius =
          std::min(deviation * c / (1 - c),
                   std::min(way.norm(), next.norm()) / 2 / std::tan(turn / 2));
      limit.push_back(std::min({a * radius, cruise(i), cruise(i + 1)}));
    }
    limit.push_back(0);
    double truth = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const int steps = 20000;
      const double length = place[i + 1] - place[i], step = length / steps;
      for (int k = 0; k < steps; ++k) {
        const double s = place[i] + (k + 0.5) * step;
        double v2 = cruise(i);
        for (std::size_t j = 0; j < place.size(); ++j)
          v2 = std::min(v2, limit[j] + 2 * a * std::abs(s - place[j]));
        truth += step / std::sqrt(v2);
      }
    }
    EXPECT_NEAR(seconds(program) / truth, 1.0, 2e-3) << seed;
  }
}

TEST(ProgramTime, IsNeverLessThanLengthOverFeed)
{
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto time = programTime(randomPath(seed, 60).program, machine()).total;
    EXPECT_GE(time.total(), time.unhindered * (1 - 1e-12)) << seed;
    Machine quick = machine();
    quick.acceleration = 1e6;
    quick.junction_deviation = 1;
    EXPECT_LT(programTime(randomPath(seed, 60).program, quick).total.total(),
              time.total());
  }
}

TEST(ProgramTime, AFeedBeyondTheMachineIsNotReached)
{
  const Program program = Path().feed(100, 0, 0, 60000).program;
  Machine m = machine();
  EXPECT_NEAR(seconds(program, m), 100 / 100.0 + 100 / 400.0, 1e-12); // as G0
  m.max_feed = 600;
  EXPECT_NEAR(seconds(program, m), 100 / 10.0 + 10 / 400.0, 1e-12);
}

TEST(ProgramTime, EachSectionHasItsOwnTime)
{
  const std::string one = "(Operation 1: roughing)\nT1 M6\nG43 H1\nS8000 M3\n"
                          "G0 X0 Y0\nG0 Z5\nG1 Z0 F600\nG1 X50\nG0 Z5\nM5\n";
  const std::string two = "(Operation 2: finishing)\nT2 M6\nG43 H2\nS9000 M3\n"
                          "G0 X0 Y0\nG0 Z5\nG1 Z0 F300\nG1 X50\nG0 Z5\nM5\n";
  Program program = read("G21 G17 G90 G94 G54\n" + one + two + "M2\n");
  // As the reader names sections; set here so that the test is of this function alone.
  std::size_t second = 0;
  while (program.moves[second].tool == 1)
    ++second;
  program.sections = {{"roughing", 1, 2, 0}, {"finishing", 2, 12, second}};
  const ProgramTime time = programTime(program, machine());
  ASSERT_EQ(time.sections.size(), 2u);
  EXPECT_EQ(time.sections[0].tool_change, 15.0);
  EXPECT_EQ(time.sections[1].tool_change, 15.0);
  EXPECT_GT(time.sections[1].cutting, 1.9 * time.sections[0].cutting);
  EXPECT_EQ(time.sections[0].rapid, time.sections[1].rapid);
  EXPECT_NEAR(
      time.total.total(), time.sections[0].total() + time.sections[1].total(), 1e-12);
  EXPECT_GT(time.total.unknown_moves, 0u); // X and Y after a tool change
  ProgramTimeOptions patient;
  patient.tool_change = 60;
  EXPECT_NEAR(programTime(program, machine(), patient).total.total(),
              time.total.total() + 90,
              1e-9);
  program.sections.clear();
  EXPECT_EQ(programTime(program, machine()).sections.size(), 1u);
  EXPECT_NEAR(programTime(program, machine()).total.total(), time.total.total(), 1e-12);
}

TEST(ProgramTime, EachMoveEndsWhenThoseBeforeAndItsOwnTimeAreOver)
{
  Path path = randomPath(11, 300);
  path.program.moves[100].tool = 2; // changed to and back
  path.program.tools = {1, 2, 1};
  const ProgramTime all = programTime(path.program, machine());
  ASSERT_EQ(all.ends.size(), path.program.moves.size());
  EXPECT_NEAR(all.ends.back(), all.total.total(), 1e-6);
  EXPECT_TRUE(std::is_sorted(all.ends.begin(), all.ends.end()));
  EXPECT_GT(all.ends[100] - all.ends[99], ProgramTimeOptions().tool_change);
  // A long move between rests: its trapezoid, on top of what came before.
  Path two;
  two.feed(10, 0, 0).feed(0, 0, 0);
  const double one = seconds(Path().feed(10, 0, 0).program);
  EXPECT_NEAR(programTime(two.program, machine()).ends[0], one, 1e-9);
}

TEST(ProgramTime, AToolThatIsMountedIsNotChanged)
{
  // No M6: the reader was told which tool is in the spindle.
  EXPECT_EQ(programTime(Path().feed(10, 0, 0).program, machine()).total.tool_change, 0);
  Program program = Path().feed(10, 0, 0).feed(20, 0, 0).program;
  program.moves[1].tool = 2;
  EXPECT_EQ(programTime(program, machine()).total.tool_change, 15);
  // It rests while the tool is changed, though the line is straight.
  EXPECT_NEAR(programTime(program, machine()).total.cutting,
              2 * seconds(Path().feed(10, 0, 0).program),
              1e-12);
}

TEST(ProgramTime, APlaceThatIsNotKnownCostsNothingButAStop)
{
  Program program = Path().feed(10, 0, 0).rapid(10, 0, 5).feed(20, 0, 5).program;
  program.moves[1].to.z() = program.moves[2].from.z() =
      std::numeric_limits<double>::infinity();
  const auto time = programTime(program, machine()).total;
  EXPECT_EQ(time.unknown_moves, 2u);
  EXPECT_NEAR(time.total(), seconds(Path().feed(10, 0, 0).program), 1e-12);
  EXPECT_EQ(programTime({}, machine()).total.total(), 0.0);
}

TEST(ProgramTime, NonsenseIsRefused)
{
  const Program program = Path().feed(10, 0, 0).program;
  Machine m = machine();
  m.acceleration = 0;
  EXPECT_THROW(programTime(program, m), ParameterError);
  ProgramTimeOptions options;
  options.tool_change = -1;
  EXPECT_THROW(programTime(program, machine(), options), ParameterError);
  EXPECT_THROW(programTime(Path().feed(10, 0, 0, 0).program, machine()), DataError);
}
