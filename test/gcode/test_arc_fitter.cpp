// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_geometry.h"
#include "arc_text.h"
#include "sample.h"

#include <pointmill/common/error.h>
#include <pointmill/gcode/arc_fitter.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <optional>

using pointmill::ArcFitter;
using pointmill::ArcPlane;
using pointmill::DecimalGrid;
using pointmill::MachineArc;
using pointmill::MachineCalls;
using pointmill::MachinePosition;
using pointmill_test::Random;

namespace {

const double pi = std::acos(-1.0);
constexpr ArcPlane planes[] = {ArcPlane::XY, ArcPlane::ZX, ArcPlane::YZ};
constexpr std::int64_t feed = 600000;
constexpr double tick = 1e-4; // mm

struct Call {
  std::optional<MachineArc> arc;
  MachinePosition to;
  std::int64_t feed = 0;

  bool operator==(const Call& o) const
  {
    return arc.has_value() == o.arc.has_value() && to == o.to && feed == o.feed &&
           (!arc || (arc->plane == o.arc->plane && arc->clockwise == o.arc->clockwise &&
                     arc->u == o.arc->u && arc->v == o.arc->v));
  }
};

/// Keeps what comes in: feed moves as they are, all calls as text.
class Recorder : public MachineCalls {
public:
  std::vector<Call> moves;
  std::string log;

  void begin(const pointmill::ProgramHead& head) override
  {
    log += "begin " + head.name + "\n";
  }
  void comment(const std::string& text) override { log += "comment " + text + "\n"; }
  void operation(std::size_t n, const std::string& name) override
  {
    log += "operation " + std::to_string(n) + " " + name + "\n";
  }
  void stop() override { log += "stop\n"; }
  void retract() override { log += "retract\n"; }
  void changeTool(int n) override { log += "tool " + std::to_string(n) + "\n"; }
  void spindle(long rpm) override { log += "spindle " + std::to_string(rpm) + "\n"; }
  void coolant(bool on) override { log += on ? "coolant\n" : "no coolant\n"; }
  void approach(const MachinePosition& to) override { log += "approach" + text(to); }
  void traverse(const MachinePosition& to) override { log += "traverse" + text(to); }
  void straight(const MachinePosition& to, std::int64_t f) override
  {
    log += "straight" + text(to);
    moves.push_back({std::nullopt, to, f});
  }
  void arc(const MachineArc& arc, std::int64_t f) override
  {
    log += "arc" + text(arc.to);
    moves.push_back({arc, arc.to, f});
  }
  void dwell(double seconds) override
  {
    log += "dwell " + std::to_string(seconds) + "\n";
  }
  void end() override { log += "end\n"; }

private:
  static std::string text(const MachinePosition& p)
  {
    return " " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
           std::to_string(p.z) + "\n";
  }
};

/// A place by its coordinates along a plane's first and second axis and across it [mm].
MachinePosition place(ArcPlane plane, double u, double v, double w, double unit = tick)
{
  const auto axis = arcs::axes(plane);
  std::int64_t p[3];
  p[axis[0]] = std::llround(u / unit);
  p[axis[1]] = std::llround(v / unit);
  p[axis[2]] = std::llround(w / unit);
  return {p[0], p[1], p[2]};
}

using Positions = std::vector<MachinePosition>;

/// From @p begin over @p sweep [deg], climbing evenly by @p climb.
Positions turn(ArcPlane plane,
               double radius,
               double begin,
               double sweep,
               int chords,
               double climb = 0.0)
{
  Positions path;
  for (int i = 0; i <= chords; ++i) {
    const double part = double(i) / chords, angle = (begin + part * sweep) * pi / 180;
    path.push_back(place(plane,
                         3 + radius * std::cos(angle),
                         -7 + radius * std::sin(angle),
                         2 + part * climb));
  }
  return path;
}

void send(const Positions& path, MachineCalls& calls)
{
  calls.traverse(path.front());
  for (std::size_t i = 1; i < path.size(); ++i)
    calls.straight(path[i], feed);
}

struct Result {
  std::vector<Call> moves;
  ArcFitter::Statistics statistics;
};

template <typename Set>
Result fitted(const Positions& path, const DecimalGrid& grid, Set&& set)
{
  Recorder recorder;
  ArcFitter fitter(recorder, grid);
  set(fitter);
  fitter.begin({});
  send(path, fitter);
  fitter.end();
  return {recorder.moves, fitter.statistics()};
}

Result fitted(const Positions& path, double tolerance)
{
  return fitted(path, DecimalGrid(4), [&](ArcFitter& f) { f.setTolerance(tolerance); });
}

arcs::Path vectors(const Positions& path)
{
  arcs::Path out;
  for (const auto& p : path)
    out.push_back(arcs::vector(p));
  return out;
}

/// What each call replaces lies within its tolerance of what a control makes of it; the
/// largest distance found [ticks]. Each place of @p path is to be there only once.
double
expectWithin(const Positions& path, const std::vector<Call>& moves, double tolerance)
{
  double most = 0;
  std::size_t at = 0;
  for (const auto& move : moves) {
    const std::size_t from = at;
    while (at < path.size() && !(path[at] == move.to && at > from))
      ++at;
    if (at == path.size()) {
      ADD_FAILURE() << "a call ends where the path has no point";
      return most;
    }
    const arcs::Path part = vectors(
        {path.begin() + std::ptrdiff_t(from), path.begin() + std::ptrdiff_t(at) + 1});
    arcs::Path way = arcs::refined({part.front(), part.back()}, 200);
    double sampling = 1e-6; // how far samples are from what they are of
    if (move.arc) {
      const arcs::Turn turn(part.front(), *move.arc);
      for (std::size_t i = 0; i < way.size(); ++i)
        way[i] = turn.at(double(i) / double(way.size() - 1));
      sampling += turn.end_radius * (1 - std::cos(turn.sweep / 400));
    }
    const double off = arcs::hausdorff(arcs::refined(part, 10), way) - sampling;
    EXPECT_LE(off, tolerance) << "points " << from << " to " << at;
    most = std::max(most, off);
  }
  EXPECT_EQ(at + 1, path.size()) << "the path has an end that no call has";
  return most;
}

} // namespace

TEST(ArcFitter, ACircleIsOneArcInEachPlaneAndSense)
{
  for (const auto plane : planes)
    for (const double sweep : {30.0, 90.0, 160.0, -30.0, -90.0, -160.0}) {
      const auto path = turn(plane, 20, 25, sweep, 500);
      const auto result = fitted(path, 0.005);
      ASSERT_EQ(result.moves.size(), 1u) << int(plane) << " " << sweep;
      const auto& call = result.moves[0];
      ASSERT_TRUE(call.arc);
      EXPECT_EQ(call.arc->plane, plane);
      EXPECT_EQ(call.arc->clockwise, sweep < 0);
      EXPECT_EQ(call.to, path.back());
      EXPECT_EQ(call.feed, feed);
      const arcs::Turn is(arcs::vector(path.front()), *call.arc);
      // A rounding of the middle shifts the centre by more where the arc is flat.
      const double off = 2 / (1 - std::cos(sweep * pi / 360));
      EXPECT_NEAR(is.u, 3 / tick, off);
      EXPECT_NEAR(is.v, -7 / tick, off);
      EXPECT_NEAR(is.degrees(), sweep, off * tick / 20 * 180 / pi);
      EXPECT_LT(result.statistics.largest_deviation, 4 * tick);
      EXPECT_EQ(result.statistics.straights_in, 500u);
      EXPECT_EQ(result.statistics.straights_out, 0u);
      EXPECT_EQ(result.statistics.arcs_out, 1u);
      EXPECT_EQ(result.statistics.helices_out, 0u);
    }
}

TEST(ArcFitter, AHelixIsOneArcThatClimbs)
{
  for (const auto plane : planes)
    for (const double climb : {-3.0, 0.4, 12.0}) {
      const auto path = turn(plane, 20, -50, 120, 300, climb);
      const auto result = fitted(path, 0.005);
      ASSERT_EQ(result.moves.size(), 1u) << int(plane) << " " << climb;
      ASSERT_TRUE(result.moves[0].arc);
      EXPECT_EQ(result.moves[0].arc->plane, plane);
      EXPECT_EQ(result.moves[0].to, path.back());
      EXPECT_EQ(result.statistics.helices_out, 1u);
      EXPECT_LT(result.statistics.largest_deviation, 4 * tick);
    }
}

TEST(ArcFitter, ASteepHelixOrOneThatClimbsUnevenlyIsNone)
{
  const double length = 20 * 120 * pi / 180;
  const auto arcs_of = [&](double degrees, double steepest) {
    const auto path =
        turn(ArcPlane::XY, 20, 0, 120, 300, length * std::tan(degrees * pi / 180));
    return fitted(path,
                  DecimalGrid(4),
                  [&](ArcFitter& f) { f.setSteepestHelix(steepest); })
        .statistics.arcs_out;
  };
  EXPECT_EQ(arcs_of(29.9, 30), 1u);
  EXPECT_EQ(arcs_of(30.1, 30), 0u);
  EXPECT_EQ(arcs_of(0.1, 0), 0u);
  EXPECT_EQ(arcs_of(0, 0), 1u);

  auto path = turn(ArcPlane::XY, 20, 0, 120, 300, 2.0);
  for (std::size_t i = 0; i < path.size(); ++i) // at most 0.01 mm from even
    path[i].z += std::llround(100 * std::sin(pi * double(i) / 300));
  EXPECT_EQ(fitted(path, 0.0104).moves.size(), 1u);
  EXPECT_GT(fitted(path, 0.0096).moves.size(), 1u);
}

TEST(ArcFitter, AFullTurnIsSeveralArcs)
{
  const auto path = turn(ArcPlane::ZX, 8, 0, 360, 360);
  for (const double largest : {80.0, 175.0, 200.0, 350.0}) {
    const auto result =
        fitted(path, DecimalGrid(4), [&](ArcFitter& f) { f.setLargestSweep(largest); });
    EXPECT_EQ(result.moves.size(), std::size_t(std::ceil(360 / largest))) << largest;
    Eigen::Vector3d at = arcs::vector(path.front());
    double sum = 0;
    for (const auto& call : result.moves) {
      ASSERT_TRUE(call.arc);
      const arcs::Turn is(at, *call.arc);
      EXPECT_LE(is.degrees(), largest);
      sum += is.degrees();
      at = is.to;
    }
    EXPECT_NEAR(sum, 360, 1) << "each tilts a little at its ends";
  }
}

TEST(ArcFitter, TwoTurnsAreNotOne)
{
  // Round nearly twice: an arc with these ends would leave out a whole turn.
  const auto path = turn(ArcPlane::XY, 1, 0, 500, 100, 0.01);
  const auto result = fitted(path, DecimalGrid(4), [](ArcFitter& f) {
    f.setTolerance(0.02);
    f.setLargestSweep(350);
  });
  EXPECT_EQ(result.moves.size(), 2u);
  expectWithin(path, result.moves, 0.02 / tick);
}

TEST(ArcFitter, AnSIsTwoArcs)
{
  auto path = turn(ArcPlane::XY, 10, 180, -90, 90); // up and to the right
  const double x = 3, y = -7 + 20;
  for (int i = 1; i <= 90; ++i) { // and up again
    const double angle = (-90 + i) * pi / 180;
    path.push_back(
        place(ArcPlane::XY, x + 10 * std::cos(angle), y + 10 * std::sin(angle), 2));
  }
  const auto moves = fitted(path, 0.003).moves;
  ASSERT_EQ(moves.size(), 2u);
  ASSERT_TRUE(moves[0].arc && moves[1].arc);
  EXPECT_TRUE(moves[0].arc->clockwise);
  EXPECT_FALSE(moves[1].arc->clockwise);
}

TEST(ArcFitter, ALineIsOneMoveAndItsCornersStay)
{
  Positions path;
  for (int i = 0; i <= 100; ++i)
    path.push_back(place(ArcPlane::XY, 0.1 * i, 0.2 * i, -0.05 * i));
  for (int i = 1; i <= 100; ++i)
    path.push_back(place(ArcPlane::XY, 10 - 0.1 * i, 20 + 0.05 * i, -5));
  const auto result = fitted(path, 0.01);
  ASSERT_EQ(result.moves.size(), 2u);
  EXPECT_FALSE(result.moves[0].arc);
  EXPECT_EQ(result.moves[0].to, path[100]);
  EXPECT_EQ(result.moves[1].to, path[200]);
  EXPECT_EQ(result.statistics.straights_out, 2u);
  EXPECT_LT(result.statistics.largest_deviation, tick);
}

TEST(ArcFitter, PointsOffALineCountByTheTolerance)
{
  Positions path{{0, 0, 0}, {10000, 0, 49}, {40000, 0, 0}};
  const auto straight = [](ArcFitter& f) {
    f.setTolerance(0.005);
    f.setArcs(false);
  };
  EXPECT_EQ(fitted(path, DecimalGrid(4), straight).moves.size(), 1u);
  path[1].z = -51;
  EXPECT_EQ(fitted(path, DecimalGrid(4), straight).moves.size(), 2u);
}

TEST(ArcFitter, AWayBackIsNotLeftOut)
{
  // Beyond the end and back, within the tolerance all along.
  const Positions path{{0, 0, 0}, {10000, 0, 0}, {20040, 0, 0}, {20000, 0, 0}};
  const auto moves = fitted(path, 0.01).moves;
  ASSERT_EQ(moves.size(), 2u);
  EXPECT_EQ(moves[0].to, path[2]);
  EXPECT_EQ(moves[1].to, path[3]);
}

TEST(ArcFitter, ChordsCountNotOnlyTheirEnds)
{
  // A polygon with its corners on a circle: its sides are inside it by the sagitta.
  const auto path = turn(ArcPlane::XY, 10, 0, 120, 12);
  const double sagitta = 10 * (1 - std::cos(5 * pi / 180));
  const auto all = fitted(path, 1.02 * sagitta);
  EXPECT_EQ(all.moves.size(), 1u);
  EXPECT_GT(all.statistics.largest_deviation, 0.9 * sagitta);
  // Two sides and an arc that is flatter by x: it passes their corner at x, and their
  // middles at sagitta - 3/4 x. So 4/7 of the sagitta is the least that there is.
  EXPECT_EQ(fitted(path, 0.60 * sagitta).statistics.arcs_out, 6u);
  EXPECT_EQ(fitted(path, 0.56 * sagitta).moves.size(), 12u);
}

TEST(ArcFitter, LimitsOfArcsAreKept)
{
  const auto arcs_of = [](const Positions& path, auto&& set) {
    return fitted(path, DecimalGrid(4), set).statistics.arcs_out;
  };
  const auto path = turn(ArcPlane::YZ, 20, 0, 60, 100);
  EXPECT_EQ(arcs_of(path, [](ArcFitter& f) { f.setArcs(false); }), 0u);
  EXPECT_EQ(arcs_of(path, [](ArcFitter& f) { f.setPlane(ArcPlane::YZ, false); }), 0u);
  EXPECT_EQ(arcs_of(path, [](ArcFitter& f) { f.setHelixPlane(ArcPlane::YZ, false); }),
            1u);
  const auto helix = turn(ArcPlane::YZ, 20, 0, 60, 100, 1);
  EXPECT_EQ(arcs_of(helix, [](ArcFitter& f) { f.setHelixPlane(ArcPlane::YZ, false); }),
            0u);
  EXPECT_EQ(arcs_of(helix, [](ArcFitter& f) { f.setHelixPlane(ArcPlane::XY, false); }),
            1u);
  EXPECT_EQ(arcs_of(path, [](ArcFitter& f) { f.setRadii(1, 20.1); }), 1u);
  EXPECT_EQ(arcs_of(path, [](ArcFitter& f) { f.setRadii(19.9, 100); }), 1u);
  const auto smallest = [](ArcFitter& f) {
    f.setTolerance(0.00015);
    f.setRadii(0.01, 1);
  };
  EXPECT_EQ(arcs_of({{0, 0, 0}, {60, 3, 0}, {120, 0, 0}}, smallest), 1u);
  EXPECT_EQ(arcs_of({{0, 0, 0}, {45, 3, 0}, {90, 0, 0}}, smallest), 0u);
}

TEST(ArcFitter, NoArcDipsBelowTheFloor)
{
  // Down and up again, with no point at the bottom: Z is the second axis of
  // YZ and the first of ZX.
  for (const auto plane : {ArcPlane::YZ, ArcPlane::ZX}) {
    const bool first = plane == ArcPlane::ZX;
    const auto path = turn(plane, 2, first ? 140 : 230, 80, 79);
    const double bottom = first ? 3 - 2 : -7 - 2;
    std::int64_t lowest = path.front().z;
    for (const auto& p : path)
      lowest = std::min(lowest, p.z);
    ASSERT_GT(double(lowest), bottom / tick);
    for (const double floor : {bottom - 0.01, double(lowest) * tick}) {
      const auto result = fitted(path, DecimalGrid(4), [&](ArcFitter& f) {
        f.setTolerance(0.005);
        f.setFloor(floor);
      });
      EXPECT_EQ(result.moves.size() == 1, floor < bottom);
      Eigen::Vector3d at = arcs::vector(path.front());
      for (const auto& call : result.moves) {
        for (int i = 0; call.arc && i <= 1000; ++i) {
          EXPECT_GE(arcs::Turn(at, *call.arc).at(i / 1000.0).z(), floor / tick - 1e-6);
        }
        at = arcs::vector(call.to);
      }
    }
  }
}

TEST(ArcFitter, RadiiKeepToTheirLimits)
{
  const auto path = turn(ArcPlane::YZ, 20, 0, 60, 200);
  const std::pair<double, double> limits[] = {{1, 19.5}, {20.5, 100}};
  for (const auto& [smallest, largest] : limits) {
    const auto result =
        fitted(path, DecimalGrid(4), [l = smallest, h = largest](ArcFitter& f) {
          f.setRadii(l, h);
        });
    EXPECT_GT(result.moves.size(), 1u);
    EXPECT_GT(result.statistics.arcs_out, 1u);
    Eigen::Vector3d at = arcs::vector(path.front());
    for (const auto& call : result.moves) {
      if (call.arc) {
        const arcs::Turn is(at, *call.arc);
        EXPECT_GE(is.start_radius, smallest / tick);
        EXPECT_LE(is.start_radius, largest / tick);
      }
      at = arcs::vector(call.to);
    }
    expectWithin(path, result.moves, 0.003 / tick);
  }
}

TEST(ArcFitter, RandomPathsStayWithinTheTolerance)
{
  Random random(3);
  std::size_t arcs = 0, helices = 0, straights = 0, replaced = 0;
  for (int round = 0; round < 150; ++round) {
    const ArcPlane plane = planes[round % 3];
    const double noise = round % 4 == 0 ? 0.0 : random.uniform(0, 0.01);
    const double slope = round % 2 == 0 ? 0.0 : random.uniform(-0.4, 0.4);
    double u = 0, v = 0, w = 0, angle = random.uniform(0, 7), bend = 0;
    Positions path;
    for (int i = 0; i < 150; ++i) {
      if (i % 25 == 0)
        bend = random.uniform() < 0.2 ? 0.0
                                      : random.uniform(-1, 1) / random.uniform(0.3, 5);
      const double step = random.uniform(0.02, 0.3);
      angle += bend * step;
      u += step * std::cos(angle);
      v += step * std::sin(angle);
      w += step * slope;
      path.push_back(place(plane,
                           u + noise * random.uniform(),
                           v + noise * random.uniform(),
                           w + noise * random.uniform()));
    }
    const double tolerance = random.uniform(0.001, 0.02);
    const auto result = fitted(path, tolerance);
    const double most = expectWithin(path, result.moves, tolerance / tick);
    EXPECT_LE(most, result.statistics.largest_deviation / tick);
    EXPECT_LE(result.statistics.largest_deviation, tolerance);
    arcs += result.statistics.arcs_out;
    helices += result.statistics.helices_out;
    straights += result.statistics.straights_out;
    replaced += path.size() - 1 - result.moves.size();
  }
  EXPECT_GT(arcs, 500u);
  EXPECT_GT(helices, 250u);
  EXPECT_GT(straights, 500u);
  EXPECT_GT(replaced, 7500u);
}

TEST(ArcFitter, TheProvenBoundIsTightInAPlane)
{
  Random random(8);
  for (int round = 0; round < 50; ++round) {
    auto path = turn(planes[round % 3], 15, 40, round % 2 ? 70 : -70, 60);
    const auto axis = arcs::axes(planes[round % 3]);
    for (auto& p : path) {
      std::int64_t* const coordinates[] = {&p.x, &p.y, &p.z};
      *coordinates[axis[0]] += std::llround(random.uniform(-30, 30));
      *coordinates[axis[1]] += std::llround(random.uniform(-30, 30));
    }
    const auto result = fitted(path, 0.01);
    ASSERT_EQ(result.moves.size(), 1u);
    const double bound = result.statistics.largest_deviation / tick;
    const double is = expectWithin(path, result.moves, bound + 1e-6);
    EXPECT_GT(is, bound - 2); // 2 ticks: the difference of the radii
  }
}

TEST(ArcFitter, BothRadiiOfAnArcAgreeWithThreeDecimals)
{
  std::size_t arcs = 0;
  for (int round = 0; round < 200; ++round) {
    Positions path;
    for (int i = 0; i <= 100; ++i) {
      const double angle = (0.3 + 1.7 * i / 100 + round) * (round % 2 ? 1 : -1);
      path.push_back(place(planes[round % 3],
                           (1 + 0.21 * round) * std::cos(angle),
                           (1 + 0.21 * round) * std::sin(angle),
                           0,
                           1e-3));
    }
    const auto result =
        fitted(path, DecimalGrid(3), [](ArcFitter& f) { f.setTolerance(0.005); });
    Eigen::Vector3d at = arcs::vector(path.front());
    for (const auto& call : result.moves) {
      if (call.arc) {
        const arcs::Turn is(at, *call.arc);
        EXPECT_LE(std::abs(is.start_radius - is.end_radius), 2.0);
        ++arcs;
      }
      at = arcs::vector(call.to);
    }
  }
  EXPECT_GT(arcs, 150u);
}

TEST(ArcFitter, OtherCallsKeepTheirPlaceAndEndARun)
{
  Recorder direct, through;
  ArcFitter fitter(through, DecimalGrid(4));
  const auto talk = [](MachineCalls& calls) {
    calls.begin({"test", {}, {}, 0.0, std::nullopt});
    calls.comment("one");
    calls.operation(1, "roughing");
    calls.stop();
    calls.retract();
    calls.changeTool(3);
    calls.spindle(8000);
    calls.coolant(true);
    calls.approach({0, 0, 10000});
    calls.straight({1000, 0, 10000}, feed);
    calls.comment("two");
    calls.straight({2000, 0, 10000}, feed);
    calls.operation(2, "finishing");
    calls.straight({3000, 0, 10000}, feed);
    calls.spindle(9000);
    calls.straight({4000, 0, 10000}, feed);
    calls.coolant(false);
    calls.straight({5000, 0, 10000}, feed);
    calls.dwell(0.5);
    calls.straight({6000, 0, 10000}, feed);
    calls.arc({{7000, 1000, 10000}, ArcPlane::XY, false, 0, 1000}, feed);
    calls.straight({7000, 2000, 10000}, feed);
    calls.traverse({7000, 3000, 10000});
    calls.straight({7000, 4000, 10000}, feed);
    calls.retract();
    calls.straight({7000, 5000, 10000}, feed);
    calls.straight({7000, 6000, 10000}, feed / 2);
    calls.stop();
    calls.end();
  };
  talk(direct);
  talk(fitter);
  EXPECT_EQ(through.log, direct.log);
  EXPECT_EQ(through.moves.size(), direct.moves.size());
}

TEST(ArcFitter, FeedsPartRunsAndMayBeLowered)
{
  Recorder recorder;
  const auto run = [&](double drop, const std::vector<std::int64_t>& feeds) {
    recorder = Recorder();
    ArcFitter fitter(recorder, DecimalGrid(4));
    fitter.setFeedDrop(drop);
    fitter.begin({});
    fitter.traverse({0, 0, 0});
    for (std::size_t i = 0; i < feeds.size(); ++i)
      fitter.straight({1000 * std::int64_t(i + 1), 0, 0}, feeds[i]);
    fitter.end();
    std::vector<std::int64_t> out;
    for (const auto& call : recorder.moves)
      out.push_back(call.feed);
    return out;
  };
  using Feeds = std::vector<std::int64_t>;
  EXPECT_EQ(run(0, {1000, 1000, 999, 999, 1000}), (Feeds{1000, 999, 1000}));
  EXPECT_EQ(run(0.1, {1000, 950, 900, 1000}), (Feeds{900}));
  EXPECT_EQ(run(0.1, {1000, 950, 899, 1000}), (Feeds{950, 899, 1000}));
}

TEST(ArcFitter, ACircleWithTwoFeedsIsTwoArcs)
{
  const auto path = turn(ArcPlane::XY, 10, 0, 100, 200);
  Recorder recorder;
  ArcFitter fitter(recorder, DecimalGrid(4));
  fitter.begin({});
  fitter.traverse(path[0]);
  for (std::size_t i = 1; i < path.size(); ++i)
    fitter.straight(path[i], i <= 120 ? feed : feed / 2);
  fitter.end();
  ASSERT_EQ(recorder.moves.size(), 2u);
  EXPECT_TRUE(recorder.moves[0].arc && recorder.moves[1].arc);
  EXPECT_EQ(recorder.moves[0].to, path[120]);
  EXPECT_EQ(recorder.moves[0].feed, feed);
  EXPECT_EQ(recorder.moves[1].feed, feed / 2);
}

TEST(ArcFitter, TheFeedBeforeIsKeptWhereItMayBe)
{
  Recorder recorder;
  ArcFitter fitter(recorder, DecimalGrid(4));
  fitter.setFeedDrop(0.1);
  fitter.begin({});
  fitter.traverse({0, 0, 0});
  fitter.straight({9000, 0, 0}, 1000);
  fitter.straight({9000, 9000, 0}, 1050); // 1000 is not a tenth less
  fitter.straight({0, 9000, 0}, 1200);    // of this it is more
  fitter.end();
  ASSERT_EQ(recorder.moves.size(), 3u);
  EXPECT_EQ(recorder.moves[0].feed, 1000);
  EXPECT_EQ(recorder.moves[1].feed, 1000);
  EXPECT_EQ(recorder.moves[2].feed, 1200);
}

TEST(ArcFitter, WhatCannotBeMergedStaysAsItIs)
{
  Random random(21);
  Positions path;
  for (int i = 0; i < 2000; ++i)
    path.push_back(place(ArcPlane::XY,
                         random.uniform(0, 50),
                         random.uniform(0, 50),
                         random.uniform(0, 50)));
  const auto result = fitted(path, 0.005);
  ASSERT_EQ(result.moves.size(), path.size() - 1);
  for (std::size_t i = 0; i < result.moves.size(); ++i)
    EXPECT_TRUE((result.moves[i] == Call{std::nullopt, path[i + 1], feed}));
  EXPECT_EQ(result.statistics.largest_deviation, 0.0);
}

TEST(ArcFitter, LongRunsGoThroughABoundedWindow)
{
  Positions path;
  for (int i = 0; i <= 10000; ++i)
    path.push_back({std::int64_t(10) * i, 0, 0});
  const auto result = fitted(path, 0.001);
  EXPECT_EQ(result.moves.size(), 20u); // of at most 512
  EXPECT_EQ(result.moves.back().to, path.back());
}

TEST(ArcFitter, AReaderUnderstandsWhatIsPrinted)
{
  for (const auto plane : planes)
    for (const double sweep : {150.0, -150.0}) {
      auto path = turn(plane, 12, 70, sweep, 300, 1.5);
      path.push_back(place(plane, 30, 40, 5));
      ArcText text(4);
      ArcFitter fitter(text, DecimalGrid(4));
      fitter.setTolerance(0.002);
      fitter.begin({});
      send(path, fitter);
      fitter.end();
      std::istringstream in(text.text);
      const auto program = pointmill::readProgram(in);
      EXPECT_EQ(program.lines, 5u) << text.text; // head, G0, arc, G1, M2
      arcs::Path read;
      for (const auto& m : program.moves)
        read.push_back(m.to);
      arcs::Path is = vectors(path);
      for (auto& p : is)
        p *= tick;
      EXPECT_LT(arcs::hausdorff(read, is), 0.002 + 1e-4); // the reader's chords
      EXPECT_EQ(program.moves.back().feed, 600.0);
    }
}

TEST(ArcFitter, StandsBehindTheWriter)
{
  const auto operations = sample::random(3000, 2, 4);
  pointmill::GCodeWriter writer;
  writer.setClearancePlane(12.5);
  Recorder direct, through;
  ArcFitter fitter(through, DecimalGrid(writer.getDecimals()));
  fitter.setTolerance(0);
  const auto statistics = writer.write(operations, direct);
  EXPECT_EQ(writer.write(operations, fitter).feed_moves, statistics.feed_moves);
  EXPECT_EQ(fitter.statistics().straights_in, statistics.feed_moves);
  EXPECT_EQ(through.moves.size(),
            fitter.statistics().straights_out + fitter.statistics().arcs_out);
  EXPECT_LE(through.moves.size(), direct.moves.size());
  EXPECT_EQ(through.moves.back().to, direct.moves.back().to);
}

TEST(ArcFitter, ParametersAreChecked)
{
  const auto refusal = [](auto&& set) {
    Recorder recorder;
    ArcFitter fitter(recorder, DecimalGrid(4));
    set(fitter);
    try {
      fitter.begin({});
    }
    catch (const pointmill::ParameterError& error) {
      EXPECT_EQ(recorder.log, "");
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal([](ArcFitter&) {}), "accepted");
  EXPECT_NE(refusal([](ArcFitter& f) { f.setTolerance(-1e-9); }).find("tolerance"),
            std::string::npos);
  EXPECT_NE(
      refusal([](ArcFitter& f) { f.setTolerance(std::nan("")); }).find("tolerance"),
      std::string::npos);
  EXPECT_NE(refusal([](ArcFitter& f) { f.setLargestSweep(360); }).find("largest_sweep"),
            std::string::npos);
  EXPECT_NE(
      refusal([](ArcFitter& f) { f.setSteepestHelix(90); }).find("steepest_helix"),
      std::string::npos);
  EXPECT_NE(refusal([](ArcFitter& f) { f.setFeedDrop(1); }).find("feed_drop"),
            std::string::npos);
  EXPECT_NE(refusal([](ArcFitter& f) { f.setRadii(11, 10); }).find("smallest_radius"),
            std::string::npos);
}
