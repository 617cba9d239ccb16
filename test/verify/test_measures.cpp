// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Gouges, residuals and the milled stock against brute force.
#include "verify_test.h"

using namespace verify_test;

namespace {

constexpr Rectangle kArea{0, 0, 14, 11};

/// A random program over a bumpy part with three tools, and what it does by brute
/// force.
struct RandomProgram {
  const Cloud::Ptr cloud = surface(kArea, 0.45, Bumps(kArea, 4, 6, 91));
  const std::vector<Tool> tools{
      Tool::flat(1, 4), Tool::bull(2, 3, 0.5), Tool::ball(3, 3)};
  Program program;
  ProgramVerifier verifier;

  explicit RandomProgram(double low)
  {
    Random random(92);
    std::ostringstream text;
    text << std::fixed << "G21 G90 G94 G54\n";
    const auto index = indexOf(*cloud);
    for (const auto& tool : tools) {
      text << "T" << tool.number << " M6\nG43 H" << tool.number
           << "\nS9000 M3\nG0 Z20.\nG0 X-6. Y-6.\n";
      for (int i = 0; i < 60; ++i) {
        const double x = random.uniform(-2, 16), y = random.uniform(-2, 13);
        const double rest = std::max(0.0, index->drop(tool, x, y).tip);
        text << "G1 X" << x << " Y" << y << " Z" << rest + random.uniform(low, 1.0)
             << " F500\n";
      }
      text << "G0 Z20.\n";
    }
    text << "M2\n";
    std::istringstream in(text.str());
    program = readProgram(in);
    verifier.setPart(index);
    verifier.setTools(tools);
    verifier.setStock({{0, 0, -1}, {14, 11, 5}});
  }
  const Tool& toolOf(const ProgramMove& m) const { return tools[m.tool - 1]; }
};

/// The value that a share of the sorted values does not reach.
double quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  const auto k = static_cast<std::size_t>(share * double(values.size()));
  return values[std::min(k, values.size() - 1)];
}

} // namespace

TEST(Measures, GougesAreThoseOfBruteForce)
{
  const RandomProgram r(-0.5);
  const auto result = r.verifier.verify(r.program);
  double worst = 0;
  std::size_t count = 0;
  for (const auto& p : *r.cloud) {
    const Eigen::Vector3d point(p.x, p.y, p.z);
    double depth = 0;
    for (const auto& m : r.program.moves)
      if (m.from.allFinite() && m.to.allFinite())
        depth = std::max(depth, brute::gouge(r.toolOf(m), m.from, m.to, point, 300));
    worst = std::max(worst, depth);
    count += depth > 0.02;
  }
  EXPECT_GT(count, 100u);
  EXPECT_NEAR(result.gouge, worst, 0.01);
  EXPECT_NEAR(double(result.gouged_points), double(count), 0.02 * double(count));
  EXPECT_NE(find(result, "gouge"), nullptr);
}

TEST(Measures, ResidualsAreThoseOfBruteForce)
{
  const RandomProgram r(0.0);
  const auto result = r.verifier.verify(r.program);
  // Height that the program leaves over each point, less what the last tool would leave
  // if it stood everywhere.
  const Tool& last = r.tools.back();
  const auto points = pointsOf(*r.cloud);
  double floor = 1e9;
  for (const auto& p : points)
    floor = std::min(floor, p.z());
  struct Place {
    double x, y, tip;
  };
  std::vector<Place> places;
  for (double y = -1.5; y <= 12.5; y += 0.1)
    for (double x = -1.5; x <= 15.5; x += 0.1)
      places.push_back({x, y, std::max(floor, brute::drop(points, last, x, y))});
  std::vector<double> residual, deviation;
  std::size_t unreachable = 0, untouched = 0;
  for (const auto& p : points) {
    double height = std::numeric_limits<double>::infinity(), perfect = height;
    for (const auto& m : r.program.moves)
      if (m.from.allFinite() && m.to.allFinite())
        height = std::min(height,
                          brute::swept(r.toolOf(m), m.from, m.to, p.x(), p.y(), 500));
    for (const auto& c : places)
      perfect =
          std::min(perfect, c.tip + last.profile(std::hypot(c.x - p.x(), c.y - p.y())));
    perfect = std::max(perfect, p.z());
    const bool reachable = perfect - p.z() <= 0.1;
    unreachable += !reachable;
    if (!std::isfinite(height)) {
      ++untouched;
      continue;
    }
    residual.push_back(std::max(0.0, height - perfect)); // a gouge leaves nothing
    if (reachable)
      deviation.push_back(height - p.z());
  }
  EXPECT_EQ(result.untouched_points, untouched);
  EXPECT_NEAR(double(result.unreachable_points),
              double(unreachable),
              0.02 * double(points.size()));
  ASSERT_EQ(result.in_reach.size(), points.size());
  EXPECT_EQ(std::count(result.in_reach.begin(), result.in_reach.end(), false),
            std::ptrdiff_t(result.unreachable_points));
  std::size_t within = 0;
  for (const double d : deviation)
    within += std::abs(d) <= 0.3;
  EXPECT_NEAR(result.shareWithin(0.3), double(within) / double(deviation.size()), 0.03);
  EXPECT_NEAR(result.deviation.p5, quantile(deviation, 0.05), 0.05);
  EXPECT_NEAR(result.residual.p50, quantile(residual, 0.5), 0.02);
  EXPECT_NEAR(result.residual.p95, quantile(residual, 0.95), 0.05);
  EXPECT_NEAR(result.residual.p99, quantile(residual, 0.99), 0.1);
  EXPECT_NEAR(
      result.residual.max, *std::max_element(residual.begin(), residual.end()), 0.05);
  EXPECT_NEAR(result.deviation.p50, quantile(deviation, 0.5), 0.02);
  EXPECT_NEAR(result.deviation.p95, quantile(deviation, 0.95), 0.05);
}

TEST(Measures, TheMilledStockIsThatOfBruteForce)
{
  RandomProgram r(-0.5);
  r.verifier.setCellSize(0.5);
  const auto result = r.verifier.verify(r.program);
  ASSERT_EQ(result.milled.width, 28u);
  ASSERT_EQ(result.milled.height, 22u);
  for (std::size_t i = 0; i < result.milled.size(); i += 7) {
    const auto& cell = result.milled[i];
    double height = 5;
    for (const auto& m : r.program.moves)
      if (!m.rapid)
        height = std::min(
            height, brute::swept(r.toolOf(m), m.from, m.to, cell.x, cell.y, 2000));
    EXPECT_NEAR(cell.z, height, 0.02) << cell.x << " " << cell.y;
  }
}

TEST(Measures, MovesAreCountedAndMeasured)
{
  const RandomProgram r(-0.5);
  const auto result = r.verifier.verify(r.program);
  std::size_t feeds = 0;
  double length = 0;
  for (const auto& m : r.program.moves)
    if (!m.rapid) {
      ++feeds;
      length += (m.to - m.from).norm();
    }
  EXPECT_EQ(feeds, 180u);
  EXPECT_EQ(result.feed_moves, feeds);
  EXPECT_NEAR(result.feed_length, length, 1e-6);
  EXPECT_EQ(result.feed_moves + result.rapid_moves, r.program.moves.size());
  for (const auto& tool : r.tools) {
    double lowest = 1e9;
    for (const auto& m : r.program.moves)
      if (m.tool == tool.number && m.from.allFinite())
        lowest = std::min({lowest, m.from.z(), m.to.z()});
    EXPECT_DOUBLE_EQ(result.lowest_tip.at(tool.number), lowest);
  }
}

TEST(Measures, TheDomeOfABallsOwnPassesHasNoResidual)
{
  // The ball drops on a fine raster over the dome: what it leaves is what it can.
  const Rectangle area{0, 0, 16, 16};
  const auto cloud = surface(area, 0.4, [](double x, double y) {
    return std::sqrt(400 - (x - 8) * (x - 8) - (y - 8) * (y - 8)) - 20;
  });
  const auto index = indexOf(*cloud);
  const Tool ball = Tool::ball(1, 4);
  Text text;
  text.over(-2, -2);
  bool back = false;
  for (double y = -2; y <= 18; y += 0.2, back = !back)
    for (double x = -2; x <= 18; x += 0.2) {
      const double along = back ? 16 - x : x;
      text.feed(along, y, std::max(index->min().z(), index->drop(ball, along, y).tip));
    }
  ProgramVerifier verifier;
  verifier.setPart(index);
  verifier.setTools({ball});
  verifier.setStock({{0, 0, -10}, {16, 16, 0}});
  verifier.setTolerance(0.05); // of chords where the ball falls off the rim
  const auto result = verifier.verify(text.end());
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_NEAR(result.residual.p50, 0, 0.005);
  EXPECT_NEAR(result.residual.p99, 0, 0.01);
  EXPECT_EQ(result.untouched_points, 0u);
  EXPECT_EQ(result.unreachable_points, 0u);
}

TEST(Measures, AreTheSameForAnyNumberOfThreads)
{
  RandomProgram r(-0.5);
  r.verifier.setNumberOfThreads(1);
  const auto one = r.verifier.verify(r.program);
  r.verifier.setNumberOfThreads(5);
  const auto five = r.verifier.verify(r.program);
  EXPECT_EQ(one.gouge, five.gouge);
  EXPECT_EQ(one.gouge_at, five.gouge_at);
  EXPECT_EQ(one.gouge_line, five.gouge_line);
  EXPECT_EQ(one.gouged_points, five.gouged_points);
  EXPECT_EQ(one.residual.p50, five.residual.p50);
  EXPECT_EQ(one.residual.max, five.residual.max);
  EXPECT_EQ(one.deviation.p99, five.deviation.p99);
  EXPECT_EQ(one.axial_depth, five.axial_depth);
  EXPECT_EQ(one.rapids_in_stock, five.rapids_in_stock);
  EXPECT_EQ(codes(one), codes(five));
  ASSERT_EQ(one.milled.size(), five.milled.size());
  for (std::size_t i = 0; i < one.milled.size(); ++i)
    ASSERT_EQ(one.milled[i].z, five.milled[i].z);
}
