// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Every control's programs are read back as the paths that they were written from.
#include "sample.h"

#include <pointmill/gcode/call_adapter.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/gcode/post.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>

namespace {

using pointmill::MachineArc;
using pointmill::MachinePosition;
using pointmill::Post;
using pointmill::Program;
using pointmill::ProgramMove;
using pointmill::Retract;
using pointmill::ToolChange;
using pointmill::Unit;

const double pi = std::acos(-1.0);

/// One way to write programs.
struct Way {
  Post post;
  Unit unit;
  ToolChange tools;
  Retract retract;

  double tick() const // mm
  {
    return unit == Unit::Inch ? 25.4 * std::pow(10.0, -post.decimals_inch)
                              : std::pow(10.0, -post.decimals_mm);
  }
  double feedStep() const // mm/min
  {
    const double step = std::pow(10.0, -post.feed_decimals);
    return unit == Unit::Inch ? step * 25.4 / post.inch_feed_factor : step;
  }
  std::string name() const
  {
    return post.name + (unit == Unit::Inch ? ", inch" : ", mm") +
           (tools == ToolChange::Pause     ? ", pause"
            : tools == ToolChange::Program ? ", by tool"
                                           : "") +
           (retract == Retract::Machine ? ", machine"
            : retract == Retract::Home  ? ", home"
                                        : ", clearance");
  }
};

std::vector<Way> ways()
{
  std::vector<Way> list;
  for (const auto& name : Post::names())
    for (const Unit unit : {Unit::Millimetre, Unit::Inch})
      for (const Retract to : {Retract::Machine, Retract::Home, Retract::Clearance}) {
        const auto post = Post::named(name);
        if (to != Retract::Clearance && post.retractLines(to).empty())
          continue;
        list.push_back({post, unit, post.tools, to});
        if (!post.tool_pause.empty())
          list.push_back({post, unit, ToolChange::Pause, to});
      }
  return list;
}

pointmill::GCodeWriter writer(const Way& way)
{
  pointmill::GCodeWriter writer;
  writer.setPost(way.post);
  writer.setUnit(way.unit);
  writer.setToolChange(way.tools);
  writer.setRetract(way.retract);
  writer.setClearancePlane(12.5);
  writer.setPathTolerance(way.post.blend.empty() ? 0.0 : 0.01);
  return writer;
}

/// Writes and reads back: of several files the one after the other, each by its form
/// and with nothing known of the one before.
Program throughText(const pointmill::GCodeWriter& writer,
                    const std::vector<pointmill::Operation>& operations)
{
  std::deque<std::pair<std::string, std::stringstream>> files;
  writer.write(operations, [&](const std::string& suffix) -> std::ostream& {
    files.emplace_back();
    files.back().first = suffix;
    return files.back().second;
  });
  Program program;
  for (auto& [name, text] : files) {
    EXPECT_EQ(pointmill::formOf(text.str()), writer.getPost().form);
    pointmill::GCodeReader reader;
    reader.setForm(writer.getPost().form);
    program.append(reader.read(text), name);
  }
  return program;
}

/// The CL points in their order, as a machine that has read the program goes to them.
/// Returns how many moves that took.
std::size_t expectSamePath(const std::vector<pointmill::Operation>& operations,
                           const Program& program,
                           double tick,
                           double feed_step)
{
  std::size_t next = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (const auto& op : operations) {
    bool first = true;
    for (const auto& p : op.path) {
      const auto reached = [&] {
        // X and Y to half a decimal, Z never below.
        return std::abs(at.x() - p.x) < 0.51 * tick + 1e-8 &&
               std::abs(at.y() - p.y) < 0.51 * tick + 1e-8 && at.z() >= p.z - 5e-6 &&
               at.z() < p.z + 1.01 * tick;
      };
      while (!reached()) {
        if (next == program.moves.size()) {
          ADD_FAILURE() << "a point is missing";
          return next;
        }
        const auto& move = program.moves[next++];
        at = move.to;
        if (first)
          continue;
        const auto how = p.getMotion();
        EXPECT_EQ(move.rapid,
                  how == pointmill::Motion::Rapid || how == pointmill::Motion::Retract);
        if (!move.rapid) {
          EXPECT_NEAR(move.feed, p.feed, 1.01 * feed_step);
        }
        EXPECT_EQ(move.tool, op.tool.number);
        EXPECT_EQ(move.spindle, op.cutting.spindle);
        EXPECT_TRUE(move.length_offset);
        EXPECT_TRUE(move.from_known);
        EXPECT_TRUE(reached());
        if (testing::Test::HasFailure()) {
          ADD_FAILURE() << "line " << move.line;
          return next;
        }
      }
      first = false;
    }
  }
  return next;
}

/// An arc as it was handed to the printer [mm].
struct SentMove {
  Eigen::Vector3d to;
  bool rapid = false;
  double feed = 0.0;
  bool arc = false;
  int u = 0, v = 1;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< along u and v
  bool clockwise = false;
};

/// Makes arcs, half and quarter and three quarters of a circle, level and rising, in
/// all planes, of cuts, and keeps what it hands on.
class Bender : public pointmill::CallAdapter {
public:
  Bender(MachineCalls& next,
         const pointmill::DecimalGrid& grid,
         std::vector<SentMove>& sent)
      : CallAdapter(next), grid_(grid), sent_(sent)
  {
  }

  void approach(const MachinePosition& to) override { pass(to, 0.0); }
  void traverse(const MachinePosition& to) override { pass(to, 0.0); }
  void straight(const MachinePosition& to, std::int64_t feed) override
  {
    const int plane = ++count_ % 4;
    if (plane == 3 || !bend(to, static_cast<pointmill::ArcPlane>(plane), feed)) {
      pass(to, feed / 1000.0);
      CallAdapter::straight(to, feed);
    }
  }

private:
  Eigen::Vector3d mm(const MachinePosition& p) const
  {
    return {grid_.value(p.x), grid_.value(p.y), grid_.value(p.z)};
  }

  void pass(const MachinePosition& to, double feed)
  {
    sent_.push_back({mm(to), feed == 0.0, feed});
    at_ = to;
    if (feed == 0.0)
      CallAdapter::traverse(to);
  }

  bool bend(const MachinePosition& to, pointmill::ArcPlane plane, std::int64_t feed)
  {
    const std::int64_t way[] = {to.x - at_.x, to.y - at_.y, to.z - at_.z};
    const int u = plane == pointmill::ArcPlane::XY   ? 0
                  : plane == pointmill::ArcPlane::ZX ? 2
                                                     : 1;
    const int v = (u + 1) % 3;
    const std::int64_t a = way[u], b = way[v];
    if ((a + b) % 2 != 0 || std::abs(a) + std::abs(b) < 2000)
      return false;
    MachineArc arc;
    arc.to = to;
    arc.plane = plane;
    arc.clockwise = count_ % 3 == 0;
    // The corner of a square on the way, or its middle.
    const bool half = a % 2 == 0 && count_ % 5 == 0;
    arc.u = half ? a / 2 : (a - b) / 2;
    arc.v = half ? b / 2 : (a + b) / 2;

    SentMove move{mm(to), false, feed / 1000.0, true, u, v};
    const Eigen::Vector3d from = mm(at_);
    move.centre = {from[u] + grid_.value(arc.u), from[v] + grid_.value(arc.v)};
    move.clockwise = arc.clockwise;
    sent_.push_back(move);
    CallAdapter::arc(arc, feed);
    at_ = to;
    return true;
  }

  pointmill::DecimalGrid grid_;
  std::vector<SentMove>& sent_;
  MachinePosition at_;
  int count_ = 0;
};

/// The angle from @p a to @p b in the arc's direction, 0 .. 2 pi.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool clockwise)
{
  double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  angle = clockwise ? -angle : angle;
  return angle < -1e-3 ? angle + 2 * pi : angle;
}

/// The moves of the program, in their order, go along what was sent.
void expectSameArcs(const std::vector<SentMove>& sent,
                    const Program& program,
                    double tick,
                    double feed_step)
{
  // Chords, rounding, and what the angles of Klartext are rounded by.
  const double near = 2e-4 + 2 * tick;
  std::size_t next = 0;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  for (const auto& move : sent) {
    const auto arm = [&](const Eigen::Vector3d& p) -> Eigen::Vector2d {
      return Eigen::Vector2d(p[move.u], p[move.v]) - move.centre;
    };
    double before = 0.0;
    for (;;) {
      ASSERT_LT(next, program.moves.size());
      const ProgramMove& m = program.moves[next++];
      const bool there = (m.to - move.to).norm() < near;
      if (move.rapid) {
        if (there)
          break;
        ASSERT_TRUE(m.rapid) << "line " << m.line;
        continue;
      }
      ASSERT_FALSE(m.rapid) << "line " << m.line;
      ASSERT_NEAR(m.feed, move.feed, 1.01 * feed_step) << "line " << m.line;
      if (!move.arc) {
        ASSERT_TRUE(there) << "line " << m.line;
        break;
      }
      const double radius = arm(start).norm(),
                   sweep = turn(arm(start), arm(move.to), move.clockwise);
      ASSERT_NEAR(arm(m.to).norm(), radius, near) << "line " << m.line;
      const double turned = turn(arm(start), arm(m.to), move.clockwise);
      ASSERT_GE(turned, before - 1e-3) << "line " << m.line;
      ASSERT_LE(turned, sweep + 1e-3) << "line " << m.line;
      const int w = 3 - move.u - move.v;
      const double rise = move.to[w] - start[w];
      ASSERT_NEAR(m.to[w],
                  start[w] + rise * turned / sweep,
                  near * (1 + std::abs(rise) / radius))
          << "line " << m.line;
      before = turned;
      if (there)
        break;
    }
    start = move.to;
  }
}

} // namespace

TEST(RoundTrip, EveryControl)
{
  const auto operations = sample::random(3000, 3, 42);
  for (const auto& way : ways()) {
    SCOPED_TRACE(way.name());
    const auto program = throughText(writer(way), operations);
    EXPECT_TRUE(program.ended);
    EXPECT_EQ(program.inches, way.unit == Unit::Inch);
    EXPECT_EQ(program.tools, (std::vector<int>{1, 2, 3}));
    const bool states = !way.post.blend.empty();
    EXPECT_NEAR(program.blend, states ? 0.01 : 0.0, 2.6e-3 * states);
    EXPECT_LE(program.blend, 0.01);
    ASSERT_EQ(program.sections.size(), 3u);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(program.sections[static_cast<std::size_t>(i)].tool, i + 1);
    const auto used = expectSamePath(operations, program, way.tick(), way.feedStep());
    // Only the last retract remains, where there is one.
    EXPECT_LE(program.moves.size() - used, 1u);
    if (HasFailure())
      return;
  }
}

TEST(RoundTrip, ArcsOfEveryControl)
{
  const auto operations = sample::random(1500, 2, 7);
  for (const auto& way : ways()) {
    SCOPED_TRACE(way.name());
    std::vector<SentMove> sent;
    auto bending = writer(way);
    const auto grid = bending.getGrid();
    bending.addAdapter([&](pointmill::MachineCalls& next) {
      sent.clear(); // what a dry run has sent
      return std::make_unique<Bender>(next, grid, sent);
    });
    const auto program = throughText(bending, operations);
    EXPECT_GT(std::count_if(sent.begin(), sent.end(), [](auto& m) { return m.arc; }),
              100);
    expectSameArcs(sent, program, way.tick(), way.feedStep());
    if (HasFailure())
      return;
  }
}

TEST(RoundTrip, TenThousandPoints)
{
  for (const int decimals : {4, 6}) {
    const auto operations = sample::random(10000, 3, 42);
    pointmill::GCodeWriter writer;
    writer.setClearancePlane(12.5);
    writer.setDecimals(decimals);
    std::stringstream text;
    const auto statistics = writer.write(operations, text);
    const auto program = pointmill::readProgram(text);
    EXPECT_TRUE(program.ended);
    EXPECT_FALSE(program.inches);
    EXPECT_EQ(program.lines, statistics.lines);
    EXPECT_EQ(program.blend, 0.01);
    EXPECT_EQ(program.merge, 0.0);
    EXPECT_EQ(program.tools, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(program.moves.size(), statistics.feed_moves + statistics.rapids);
    EXPECT_EQ(expectSamePath(operations, program, std::pow(10.0, -decimals), 1e-3) + 1,
              program.moves.size())
        << "only the last retract remains";
  }
}

TEST(RoundTrip, RapidsKeepTheirRules)
{
  std::stringstream text(sample::write(sample::random(10000, 3, 5), 12.5));
  for (const auto& m : pointmill::readProgram(text).moves) {
    if (!m.rapid || !m.to.allFinite() || !m.from_known)
      continue;
    const bool sideways = (m.to - m.from).head<2>().norm() > 0;
    if (sideways) {
      EXPECT_GE(m.from.z(), 12.5);
      EXPECT_EQ(m.from.z(), m.to.z());
    }
  }
}

TEST(RoundTrip, MovesCanBeReadOneByOne)
{
  const auto text = sample::write(sample::random(3000, 2, 9), 12.5);
  std::istringstream whole(text), pieces(text);
  const auto program = pointmill::readProgram(whole);
  std::size_t n = 0;
  const auto rest = pointmill::GCodeReader().read(pieces, [&](const auto& m) {
    ASSERT_LT(n, program.moves.size());
    EXPECT_EQ(m.line, program.moves[n++].line);
  });
  EXPECT_EQ(n, program.moves.size());
  EXPECT_TRUE(rest.moves.empty());
  EXPECT_EQ(rest.lines, program.lines);
}
