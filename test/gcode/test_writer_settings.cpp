// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Units, numbers, limits, retracts and splitting, whatever the control.
#include "two_tools.h"

#include <pointmill/common/error.h>
#include <pointmill/gcode/gcode_reader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using pointmill::ArcPlane;
using pointmill::GCodeWriter;
using pointmill::MachineCalls;
using pointmill::ParameterError;
using pointmill::Post;
using pointmill::Program;
using pointmill::Retract;
using pointmill::ToolChange;
using pointmill::Unit;

namespace {

std::string one(const GCodeWriter& writer,
                const std::vector<pointmill::Operation>& operations)
{
  std::ostringstream out;
  writer.write(operations, out);
  return out.str();
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

Program read(const std::string& text)
{
  std::istringstream in(text);
  return pointmill::readProgram(in);
}

Program readAll(const sample::Files& files)
{
  Program all;
  for (std::size_t i = 1; i <= files.size(); ++i)
    for (const auto& [suffix, text] : files)
      if (files.size() == 1 || suffix == "_" + std::to_string(i))
        all.append(read(text.str()), suffix);
  return all;
}

/// Where feed moves go, without those that repeat the place they begin at.
std::vector<Eigen::Vector3d> feedEnds(const Program& program)
{
  std::vector<Eigen::Vector3d> ends;
  for (const auto& move : program.moves)
    if (!move.rapid && (ends.empty() || ends.back() != move.to))
      ends.push_back(move.to);
  return ends;
}

std::vector<double> lines(const sample::Files& files)
{
  std::vector<double> counts;
  for (const auto& [suffix, text] : files) {
    const auto program = text.str();
    counts.push_back(double(std::count(program.begin(), program.end(), '\n')));
  }
  return counts;
}

} // namespace

TEST(WriterSettings, InchesAreTheSamePathWithinHalfATick)
{
  auto writer = sample::plainWriterFor(Post::named("linuxcnc"));
  writer.setClearancePlane(12.5);
  const auto operations = sample::random(2000, 2, 4);
  const auto mm = read(one(writer, operations));
  writer.setUnit(Unit::Inch);
  const std::string text = one(writer, operations);
  EXPECT_TRUE(has(text, "G17 G20 "));
  EXPECT_TRUE(has(text, "G64 P0.00078 ")); // 0.02 mm, downwards
  const auto inches = read(text);
  EXPECT_TRUE(inches.inches);
  ASSERT_EQ(inches.moves.size(), mm.moves.size());
  const double tick = 25.4e-5;
  for (std::size_t i = 0; i < mm.moves.size(); ++i) {
    const auto &a = mm.moves[i], &b = inches.moves[i];
    EXPECT_EQ(a.rapid, b.rapid);
    EXPECT_NEAR(a.feed, b.feed, 25.4e-3); // F has 3 decimals
    EXPECT_LE(b.feed, a.feed + 1e-9);
    for (int axis = 0; axis < 2; ++axis)
      if (std::isfinite(a.to[axis])) {
        EXPECT_NEAR(a.to[axis], b.to[axis], tick / 2 + 0.5e-4 + 1e-9);
      }
    if (std::isfinite(a.to.z())) {
      EXPECT_GT(b.to.z(), a.to.z() - 1e-4 - 1e-9);
      EXPECT_LT(b.to.z(), a.to.z() + tick + 1e-9);
    }
  }
}

TEST(WriterSettings, InchesNeverCutDeeper)
{
  const pointmill::DecimalGrid grid(4, 25.4);
  for (int i = -50000; i <= 50000; ++i) {
    const auto z = static_cast<float>(i * 0.00137);
    const auto written = grid.value(grid.atOrAbove(z));
    ASSERT_GE(static_cast<float>(written), z);
    ASSERT_LT(written, double(z) + 25.4e-4);
  }
  EXPECT_EQ(grid.atOrAbove(25.4f), 10000) << "an inch is an inch";
  EXPECT_EQ(grid.text(grid.nearest(-12.7)), "-0.5");
}

TEST(WriterSettings, ThreeDecimalsOfAnInchAreTooFew)
{
  auto writer = sample::writerFor(Post::named("linuxcnc"));
  writer.setDecimals(3);
  EXPECT_NO_THROW(one(writer, sample::twoTools()));
  writer.setUnit(Unit::Inch);
  EXPECT_THROW(one(writer, sample::twoTools()), ParameterError);
}

TEST(WriterSettings, FeedsInInchesCountAsTheControlDoes)
{
  auto operations = sample::twoTools();
  for (auto& p : operations[0].path)
    p.feed = 254; // 10 inches a minute
  const auto written = [&](const char* post) {
    auto writer = sample::writerFor(Post::named(post), Unit::Inch);
    return sample::files(writer, operations).begin()->second.str();
  };
  EXPECT_TRUE(has(written("linuxcnc"), " F10.\n"));
  EXPECT_TRUE(has(written("grbl"), " F10.\n"));
  EXPECT_TRUE(has(written("heidenhain"), " F100\n")); // tenths
}

TEST(WriterSettings, SlowFeedsAreNotWrittenAsNone)
{
  auto operations = sample::twoTools();
  operations[0].path[2].feed = 0.001f;
  for (const auto& name : Post::names()) {
    const auto writer = sample::writerFor(Post::named(name));
    const auto text = sample::files(writer, operations).begin()->second.str();
    EXPECT_FALSE(has(text, "F0.\n") || has(text, "F0\n") || has(text, "F0 ")) << name;
  }
}

TEST(WriterSettings, LineNumbers)
{
  auto writer = sample::writerFor(Post::named("fanuc"));
  writer.setLineNumbers(true);
  const std::string text = one(writer, sample::twoTools());
  EXPECT_EQ(text.find("%\nO1001 (BRACKET)\n(POINTMILL"), 0u);
  EXPECT_TRUE(has(text, "\nN10 G17 "));
  EXPECT_TRUE(has(text, "\nN20 G61\n(OPERATION 1: ROUGH  ALL)\nN30 M9\nN40 M5\n"));
  EXPECT_TRUE(has(text, " M30\n%\n"));

  auto post = Post::named("fanuc");
  post.number_start = 5;
  post.number_step = 50;
  post.number_max = 99;
  writer.setPost(post);
  EXPECT_TRUE(has(one(writer, sample::twoTools()),
                  "\nN5 G17 G21 G40 G49 G54 G80 G90 G94\nN55 G61\n(OPERATION 1: ROUGH  "
                  "ALL)\nN5 M9\nN55 M5\n"));

  writer = sample::writerFor(Post::named("heidenhain-iso"));
  writer.setLineNumbers(false);
  EXPECT_FALSE(has(one(writer, sample::twoTools()), "N1"));
}

TEST(WriterSettings, FasterFeedsAreSlowedDown)
{
  auto writer = sample::writerFor(Post::named("linuxcnc"));
  writer.setMaxFeed(500);
  std::ostringstream out;
  const auto statistics = writer.write(sample::twoTools(), out);
  EXPECT_EQ(statistics.slowed, 5u); // 3 x 1000, 812.5, 600
  const auto program = read(out.str());
  double fastest = 0;
  for (const auto& move : program.moves)
    fastest = std::max(fastest, move.feed);
  EXPECT_EQ(fastest, 500.0);
  EXPECT_TRUE(has(out.str(), "F300."));

  writer.setUnit(Unit::Inch); // 19.685039... inches a minute
  EXPECT_TRUE(has(one(writer, sample::twoTools()), "F19.685\n"));
  writer.setMaxFeed(-1);
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
}

TEST(WriterSettings, Retracts)
{
  const auto written = [](const char* post, Retract retract) {
    auto writer = sample::writerFor(Post::named(post));
    writer.setRetract(retract);
    return sample::files(writer, sample::twoTools()).begin()->second.str();
  };
  EXPECT_TRUE(has(written("linuxcnc", Retract::Home), "G28 G91 Z0.\nG90\nT1 M6\n"));
  EXPECT_TRUE(has(written("linuxcnc", Retract::Clearance),
                  "G0 Z10.\n(Operation 2: Finish)\nM5 M9\nT2 M6\n"));
  EXPECT_TRUE(has(written("fanuc", Retract::Machine), "G53 G0 Z0.\nG49\nT1 M6\n"));
  EXPECT_TRUE(has(written("grbl", Retract::Machine), "G53 G0 Z0.\nT1\n"));
  EXPECT_TRUE(has(written("grbl", Retract::Home), "G28 G91 Z0.\nG90\nT1\n"));
  for (const char* post : {"siemens", "heidenhain", "heidenhain-iso"})
    EXPECT_THROW(written(post, Retract::Home), ParameterError) << post;
  EXPECT_TRUE(
      has(written("heidenhain", Retract::Clearance), " M9\n10 M5\n11 TOOL CALL "));
}

TEST(WriterSettings, CornersCanBeLeftToTheControl)
{
  for (const auto& name : Post::names()) {
    auto writer = sample::writerFor(Post::named(name));
    writer.setCorners(pointmill::Corners::Control);
    const auto text = sample::files(writer, sample::twoTools()).begin()->second.str();
    for (const char* word :
         {"G61", "G64", "G187", "G642", "G60", "CTOL", "CYCL", "G62"})
      EXPECT_FALSE(has(text, word)) << name;
    EXPECT_TRUE(has(text, "left to the control") || has(text, "LEFT TO THE CONTROL"))
        << name;
  }
}

TEST(WriterSettings, NoToleranceIsExactPath)
{
  const auto written = [](const char* post) {
    auto writer = sample::writerFor(Post::named(post));
    writer.setPathTolerance(0);
    return sample::files(writer, sample::twoTools()).begin()->second.str();
  };
  for (const char* post : {"linuxcnc", "mach", "fanuc", "haas"})
    EXPECT_TRUE(has(written(post), "\nG61\n")) << post;
  EXPECT_TRUE(has(written("siemens"), "\nG60\n"));
  EXPECT_TRUE(has(written("heidenhain"), " CYCL DEF 32.1 T0\n"));
  EXPECT_TRUE(has(written("heidenhain-iso"), " G62 T0\n"));
}

TEST(WriterSettings, OneToolInEachProgram)
{
  auto operations = sample::twoTools();
  operations.push_back(operations[0]);
  operations[2].name = "Again";
  auto writer = sample::plainWriterFor(Post::named("fanuc"));
  writer.setToolChange(ToolChange::Program);
  auto files = sample::files(writer, operations);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_TRUE(has(files["_1_T1"].str(), "O1001 (BRACKET_1_T1)"));
  EXPECT_TRUE(has(files["_2_T2"].str(), "O1002 (BRACKET_2_T2)"));
  EXPECT_TRUE(has(files["_3_T1"].str(), "O1003 (BRACKET_3_T1)"));
  EXPECT_TRUE(has(files["_3_T1"].str(), "(OPERATION 3: AGAIN)"));
  EXPECT_FALSE(has(files["_3_T1"].str(), "(T2 "));
  for (const auto& [suffix, text] : files) {
    EXPECT_TRUE(has(text.str(), "G0 G43 Z")) << suffix;
    EXPECT_TRUE(has(text.str(), "M30\n%\n")) << suffix;
  }
  // Neighbours of one tool stay together; a single program has no suffix.
  operations = {operations[0], operations[2]};
  files = sample::files(writer, operations);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files.begin()->first, "");
  EXPECT_TRUE(has(files[""].str(), "(OPERATION 2: AGAIN)"));
}

TEST(WriterSettings, OneStreamIsOneProgram)
{
  std::ostringstream out;
  const auto writer = sample::writerFor(Post::named("grbl"));
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
  EXPECT_EQ(out.str(), "");
  EXPECT_NO_THROW(writer.write({sample::twoTools()[0]}, out));
}

TEST(WriterSettings, LongProgramsAreSplitAndMillTheSame)
{
  auto writer = sample::plainWriterFor(Post::named("linuxcnc"));
  writer.setClearancePlane(12.5);
  auto operations = sample::random(3000, 2, 4);
  const auto whole = read(one(writer, operations));
  for (const int limit : {300, 1000, 5000}) {
    writer.setMaxLines(limit);
    const auto files = sample::files(writer, operations);
    const auto counts = lines(files);
    EXPECT_LE(*std::max_element(counts.begin(), counts.end()), limit);
    EXPECT_GE(double(files.size()), 3100.0 / limit);
    EXPECT_LE(double(files.size()), 1 + 3200.0 / (0.7 * limit));
    const auto all = readAll(files);
    EXPECT_TRUE(all.ended);
    // At the cuts the tool comes down to where it was: a place that repeats.
    EXPECT_EQ(feedEnds(all), feedEnds(whole)) << limit;
    for (const auto& m : all.moves) {
      if (!m.rapid) {
        EXPECT_TRUE(m.from_known && m.length_offset && m.spindle > 0)
            << all.where(m.line);
      }
      const bool sideways =
          m.from_known && m.to.allFinite() && (m.to - m.from).head<2>().norm() > 0;
      EXPECT_FALSE(m.rapid && sideways && m.to.z() < 12.5) << all.where(m.line);
    }
  }
}

TEST(WriterSettings, ALongCutIsLeftUpwardsAndEnteredDownwards)
{
  pointmill::Operation operation = sample::small();
  operation.path.resize(3); // down at 0, 0
  for (int i = 1; i <= 200; ++i)
    operation.path.push_back(sample::at(i, i % 2, -1.5, pointmill::Motion::Cut, 777));
  operation.path.push_back(sample::at(200, 0, 10, pointmill::Motion::Retract));
  auto writer = sample::plainWriterFor(Post::named("linuxcnc"));
  writer.setMaxLines(120);
  auto files = sample::files(writer, {operation});
  ASSERT_GE(files.size(), 2u);
  const std::string first = files["_1"].str(), second = files["_2"].str();
  EXPECT_TRUE(has(first, "(program 1 of " + std::to_string(files.size()) + ")"));
  const auto end = read(first).moves.rbegin(); // the retract, before it the lift
  EXPECT_TRUE((end + 1)->rapid);
  EXPECT_EQ((end + 1)->to.z(), 10.0);
  const auto cut = (end + 2)->to;
  EXPECT_EQ(cut.z(), -1.5);
  const auto head = "\nT1 M6\nG43 H1\nS10000 M3\nM8\nG0 Z10.\nG0 X" +
                    std::to_string(int(cut.x())) + ". Y" +
                    std::to_string(int(cut.y())) +
                    ".\nZ-0.5\nG1 Z-1.5 F777.\n"; // the last millimetre is fed
  EXPECT_TRUE(has(second, head)) << second;
  EXPECT_EQ(feedEnds(readAll(files)).size(), 201u);
}

TEST(WriterSettings, SplitsAtARapidWhereOneIsNear)
{
  std::vector<pointmill::Operation> operations(1, sample::small());
  auto& path = operations[0].path;
  path.clear();
  for (int i = 0; i < 100; ++i) {
    path.push_back(sample::at(i, 0, 10, pointmill::Motion::Rapid));
    path.push_back(sample::at(i, 0, -1, pointmill::Motion::Plunge, 300));
    path.push_back(sample::at(i, 20, -1, pointmill::Motion::Cut, 300));
    path.push_back(sample::at(i, 20, 10, pointmill::Motion::Retract));
  }
  auto writer = sample::plainWriterFor(Post::named("linuxcnc"));
  const auto whole = read(one(writer, operations));
  writer.setMaxLines(150);
  const auto files = sample::files(writer, operations);
  ASSERT_GE(files.size(), 3u);
  std::size_t feeds = 0, feeds_whole = 0;
  for (const auto& m : readAll(files).moves)
    feeds += !m.rapid;
  for (const auto& m : whole.moves)
    feeds_whole += !m.rapid;
  EXPECT_EQ(feeds, feeds_whole) << "no cut was interrupted";
}

TEST(WriterSettings, WhatFitsIsNotSplit)
{
  const auto operations = sample::random(900, 2, 4);
  auto writer = sample::plainWriterFor(Post::named("linuxcnc"));
  writer.setClearancePlane(12.5);
  const std::string whole = one(writer, operations);
  const auto count = static_cast<int>(std::count(whole.begin(), whole.end(), '\n'));
  writer.setMaxLines(count);
  EXPECT_EQ(one(writer, operations), whole);
  writer.setMaxLines(count - 1);
  EXPECT_EQ(sample::files(writer, operations).size(), 2u);
}

TEST(WriterSettings, TooFewLinesForAProgramAreRefused)
{
  auto writer = sample::writerFor(Post::named("linuxcnc"));
  writer.setMaxLines(30);
  std::ostringstream out;
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
  EXPECT_EQ(out.str(), "");
}

TEST(WriterSettings, ArcsThatAControlDoesNotTakeBecomeChords)
{
  auto post = Post::named("linuxcnc");
  auto writer = sample::writerFor(post);
  const auto arcs = read(one(writer, sample::twoTools()));
  post.arc_planes.clear();
  writer = sample::writerFor(post);
  const std::string text = one(writer, sample::twoTools());
  EXPECT_FALSE(has(text, "G2 ") || has(text, "G3 ") || has(text, "G18"));
  const auto chords = read(text);
  // Each end of a chord is near an arc's chord, which is within 1e-4 of it.
  for (const auto& m : chords.moves) {
    if (m.rapid)
      continue;
    double nearest = 1e9;
    for (const auto& a : arcs.moves) {
      if (a.rapid)
        continue;
      const Eigen::Vector3d along = a.to - a.from;
      const double t = std::clamp(
          (m.to - a.from).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
      nearest = std::min(nearest, (a.from + t * along - m.to).norm());
    }
    EXPECT_LT(nearest, 4e-4); // the rounding of three axes, and the reader's chords
  }
}

TEST(WriterSettings, WideArcsAreDividedWhereTheControlWantsThat)
{
  auto post = Post::named("linuxcnc");
  for (const double largest : {180.0, 90.0, 30.0}) {
    post.largest_sweep = largest;
    auto writer = sample::plainWriterFor(post);
    const auto mm = [&writer](double value) { return writer.getGrid().nearest(value); };
    // A full circle comes as an arc to where it starts.
    class Circle : public pointmill::CallAdapter {
    public:
      Circle(MachineCalls& next, std::int64_t radius) : CallAdapter(next), u_(radius) {}
      void straight(const pointmill::MachinePosition& to, std::int64_t feed) override
      {
        CallAdapter::straight(to, feed);
        CallAdapter::arc({to, ArcPlane::XY, false, u_, 0}, feed);
      }

    private:
      std::int64_t u_;
    };
    const auto radius = mm(7.5);
    writer.addAdapter([radius](MachineCalls& next) {
      return std::make_unique<Circle>(next, radius);
    });
    auto operation = sample::small();
    operation.path.erase(operation.path.begin() + 3, operation.path.begin() + 5);
    operation.path[3].x = operation.path[3].y = 0;
    const std::string text = one(writer, {operation});
    const auto program = read(text);
    std::size_t arcs = 0;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      arcs += has(line, "I") || has(line, "J");
    // "(PointMill" is in the head, "Operation" has no capital I or J.
    EXPECT_EQ(double(arcs), 360 / largest) << text;
    double length = 0;
    for (const auto& m : program.moves)
      if (!m.rapid && m.to.z() == -1.5 && m.from.z() == -1.5) {
        length += (m.to - m.from).norm();
        EXPECT_NEAR((m.to - Eigen::Vector3d(7.5, 0, -1.5)).norm(), 7.5, 1.5e-4);
      }
    EXPECT_NEAR(length, 15 * 3.14159265358979, 2e-3);
  }
}

TEST(WriterSettings, AdaptersStandInTheirOrder)
{
  struct Note : pointmill::CallAdapter {
    Note(MachineCalls& next, std::string& to, char name)
        : CallAdapter(next), to_(to), name_(name)
    {
    }
    void end() override
    {
      to_ += name_;
      CallAdapter::end();
    }
    std::string& to_;
    char name_;
  };
  std::string order;
  auto writer = sample::writerFor(Post::named("linuxcnc"));
  for (const char name : {'a', 'b', 'c'})
    writer.addAdapter([&order, name](MachineCalls& next) {
      return std::make_unique<Note>(next, order, name);
    });
  one(writer, sample::twoTools());
  EXPECT_EQ(order, "abc");
}

TEST(WriterSettings, RefusesNamesAndNumbers)
{
  std::ostringstream out;
  auto writer = sample::writerFor(Post::named("fanuc"));
  for (const char* bad :
       {"", "a b", "a(b", "\xC3\xA4", "123456789012345678901234567890123"}) {
    writer.setProgramName(bad);
    EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError) << bad;
  }
  writer.setProgramName("part-1");
  for (const int bad : {0, 8000}) {
    writer.setProgramNumber(bad);
    EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError) << bad;
  }
  writer.setProgramNumber(7999);
  EXPECT_NO_THROW(writer.write(sample::twoTools(), out));
  writer.setToolChange(ToolChange::Program);
  const GCodeWriter::Opener open = [&out](const auto&) -> auto&
  {
    return out;
  };
  EXPECT_THROW(writer.write(sample::twoTools(), open), ParameterError);
  writer.setToolChange(ToolChange::Pause);
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
}

TEST(WriterSettings, RefusesWhatTheControlCannot)
{
  std::ostringstream out;
  auto writer = sample::writerFor(Post::named("grbl"));
  writer.setToolChange(
      ToolChange::Changer); // T alone would mill on with the first tool
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
  writer = sample::writerFor(Post::named("heidenhain"));
  for (int axis = 0; axis < 3; ++axis) {
    auto stock = *writer.getStock();
    stock.max[axis] = std::nan("");
    writer.setStock(stock);
    EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
    stock.max[axis] = 1;
    writer.setStock(stock);
  }
  auto post = Post::named("linuxcnc");
  post.approach.clear();
  writer = sample::writerFor(post);
  EXPECT_THROW(writer.write(sample::twoTools(), out), ParameterError);
  EXPECT_EQ(out.str(), "");
}
