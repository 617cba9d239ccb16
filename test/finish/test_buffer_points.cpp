// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Buffer points: no chord errs by more than the tolerance.
#include "finish_test.h"

#include <pointmill_test/freeform.h>

using namespace finish_test;

namespace {

constexpr double kRounding = 2e-5; // float32, and steps of 0.01 mm along a chord

struct Case {
  Cloud::Ptr cloud;
  Tool tool = Tool::ball(1, 3);
  double allowance = 0, tolerance = 0.01, forward_step = 1.0, step_over = 1.0;

  CLCloud coarse() const
  {
    CLSurface<pcl::PointXYZ> stage;
    stage.setTool(tool);
    stage.setStepOver(step_over);
    stage.setForwardStep(forward_step);
    stage.setAllowance(allowance);
    return raster(stage, cloud);
  }
  BufferPoints<pcl::PointXYZ> buffer() const
  {
    BufferPoints<pcl::PointXYZ> stage;
    stage.setSurface(cloud);
    stage.setTool(tool);
    stage.setAllowance(allowance);
    stage.setTolerance(tolerance);
    return stage;
  }
  CLCloud fine(const CLCloud& path) const
  {
    auto stage = buffer();
    return run(stage, path);
  }
  CLCloud fine() const { return fine(coarse()); }

  static CLCloud run(BufferPoints<pcl::PointXYZ>& stage, const CLCloud& path)
  {
    CLCloud output;
    stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
    stage.filter(output);
    return output;
  }
};

/// A plate with a fin: one row of points 6 mm high at x = 10.27.
Cloud::Ptr fin()
{
  Cloud::Ptr cloud = surface({0, 0, 20, 8}, 0.25, [](double, double) { return 0; });
  addSurface(*cloud, {10.27, 2, 10.27, 6}, 0.25, [](double, double) { return 6; });
  return cloud;
}

/// Pairs of the same label in a row.
std::size_t chords(const CLCloud& path)
{
  std::size_t count = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    count += path[i].label == path[i - 1].label;
  return count;
}

} // namespace

TEST(BufferPoints, NoChordCutsIntoStairs)
{
  Case c;
  c.cloud = surface({9.3, 0, 33.3, 4}, 0.2, [](double x, double) {
    return 3 * std::floor(x / 8); // treads of 8, 3 high
  });
  const auto points = pointsOf(*c.cloud);
  for (const auto& tool : kTools)
    for (const double allowance : {0.0, 0.3}) {
      c.tool = tool;
      c.allowance = allowance;
      const auto coarse = c.coarse();
      EXPECT_GT(deepest(coarse, tool, allowance, points), 0.02) << tool.describe();
      EXPECT_LE(deepest(c.fine(coarse), tool, allowance, points), 0.01 + kRounding)
          << tool.describe();
    }
}

TEST(BufferPoints, NoChordCutsIntoAFinBetweenTwoHarmlessEnds)
{
  // Two CL points on the plate with the fin right between them, out of reach of both.
  Case c;
  c.cloud = fin();
  const auto points = pointsOf(*c.cloud);
  for (const auto& tool : kTools) {
    c.tool = tool;
    CLCloud path;
    path.push_back(PointCL(5, 4, 0));
    path.push_back(PointCL(15, 4, 0));
    ASSERT_GT(deepest(path, tool, 0, points), 1);
    const auto fine = c.fine(path);
    EXPECT_LE(deepest(fine, tool, 0, points), 0.01 + kRounding) << tool.describe();
    float top = 0;
    for (const auto& p : fine)
      top = std::max(top, p.z);
    EXPECT_NEAR(top, 6, 0.05) << tool.describe();
    EXPECT_EQ(fine.front().x, 5.f);
    EXPECT_EQ(fine.back().x, 15.f);
    EXPECT_EQ(fine.back().z, 0.f);
  }
}

TEST(BufferPoints, AFinSeenAtAnAngleIsPassedToo)
{
  Case c;
  c.cloud = fin();
  const auto points = pointsOf(*c.cloud);
  Random random(31);
  for (int i = 0; i < 12; ++i) {
    CLCloud path;
    for (const double x : {random.uniform(3, 8), random.uniform(12.5, 17)}) {
      const double y = random.uniform(0, 8);
      path.push_back(PointCL(x, y, brute::drop(points, c.tool, x, y) + 1e-6));
    }
    EXPECT_LE(deepest(c.fine(path), c.tool, 0, points), 0.01 + kRounding) << i;
  }
}

TEST(BufferPoints, AWallIsRisenOnItsFreeSide)
{
  // Up the wall where the tool is still beside it; down only when it is past.
  Case c;
  c.cloud = fin();
  c.tool = Tool::flat(1, 3);
  CLCloud path;
  path.push_back(PointCL(5, 4, 0));
  path.push_back(PointCL(15, 4, 0));
  const auto fine = c.fine(path);
  int up = 0, down = 0;
  for (std::size_t i = 1; i < fine.size(); ++i) {
    const double rise = double(fine[i].z) - fine[i - 1].z;
    if (std::abs(rise) < 1)
      continue;
    EXPECT_EQ(fine[i].x, fine[i - 1].x) << "a leap is vertical";
    const double gap = std::abs(fine[i].x - 10.27) - 1.5; // to the fin
    EXPECT_GE(gap, -1e-5);
    EXPECT_LE(gap, 0.02 + 1e-5); // the shortest chord
    (rise > 0 ? up : down) += 1;
  }
  EXPECT_EQ(up, 1);
  EXPECT_EQ(down, 1);
  auto stage = c.buffer();
  Case::run(stage, path);
  EXPECT_EQ(stage.getReport().get("leaps"), 2);
}

TEST(BufferPoints, OnASmoothSurfaceChordsStayNearTheTrueCurve)
{
  // The true curve of a ball over a wave is the wave's parallel curve; here it is taken
  // from the points themselves.
  Case c;
  c.cloud = surface(
      {0, -2, 24, 2}, 0.05, [](double x, double) { return 2 * std::sin(x / 2.5); });
  c.step_over = 4;
  c.forward_step = 2;
  const auto index = indexOf(*c.cloud); // exact, as test/surface shows
  std::size_t last = 1u << 30;
  for (const double tolerance : {0.002, 0.01, 0.05}) {
    c.tolerance = tolerance;
    const auto fine = c.fine();
    EXPECT_LT(fine.size(), last) << "fewer points for a wider tolerance";
    last = fine.size();
    double worst = 0;
    forMovesOfPasses(fine, [&](const auto& a, const auto& b, const PointCL&) {
      const double length = (b - a).template head<2>().norm();
      if (length < 0.02 || a.x() < 0 || b.x() < 0 || a.x() > 24 || b.x() > 24 ||
          std::abs(a.y()) > 2)
        return;
      for (int i = 0; i <= 60; ++i) {
        const Eigen::Vector3d p = a + (b - a) * (i / 60.0);
        const double above = p.z() - index->drop(c.tool, p.x(), p.y()).tip;
        worst = std::max(worst, above * length / (b - a).norm());
      }
    });
    EXPECT_LE(worst, 1.05 * tolerance) << tolerance;
    EXPECT_LE(deepest(fine, c.tool, 0, pointsOf(*c.cloud)), tolerance + kRounding);
  }
  EXPECT_LT(last, 200u);
}

TEST(BufferPoints, ChordsOverScatteredPointsAreProvenOnBothSides)
{
  // Few random points: the true curve is all arcs and cusps, and leaps at the rim.
  Case c;
  c.cloud = Freeform::sample(1500, 20, 0.2, 12);
  c.step_over = 5;
  const auto index = indexOf(*c.cloud);
  for (const Tool& tool : {Tool::ball(1, 3), Tool::bull(2, 4, 0.8)})
    for (const ToleranceBand band : {ToleranceBand{0.002, 0.02}, {0.02, 0.004}}) {
      c.tool = tool;
      auto stage = c.buffer();
      stage.setTolerance(band);
      const auto fine = Case::run(stage, c.coarse());
      double high = 0, low = 0;
      forMovesOfPasses(fine, [&](const auto& a, const auto& b, const PointCL&) {
        const double length = (b - a).template head<2>().norm();
        if (length < 0.021) // a leap, or as short as a chord may get
          return;
        for (int i = 0; i <= 40; ++i) {
          const Eigen::Vector3d p = a + (b - a) * (i / 40.0);
          const double tip =
              std::max(index->drop(tool, p.x(), p.y()).tip, index->min().z());
          high = std::max(high, (p.z() - tip) * length / (b - a).norm());
        }
      });
      low = deepest(fine, tool, 0, pointsOf(*c.cloud));
      EXPECT_LE(high, band.outside + kRounding) << tool.describe();
      EXPECT_LE(low, band.inside + kRounding) << tool.describe();
      EXPECT_GT(high, 0.7 * band.outside) << "the band is used";
    }
}

TEST(BufferPoints, OverASmoothModelChordsFollowTheTrueSurface)
{
  // 4 points/mm2, where bare points let the ball sink by 0.03 mm.
  const auto cloud = Freeform::sample(3600, 30, 0, 12);
  const auto model = std::make_shared<SurfaceModel>(indexOf(*cloud), SmoothSurface());
  CLSurface<pcl::PointXYZ> rows;
  rows.setModel(model);
  rows.setTool(Tool::ball(1, 3));
  rows.setStepOver(3);
  rows.setForwardStep(1);
  BufferPoints<pcl::PointXYZ> stage;
  stage.setModel(model);
  stage.setTool(Tool::ball(1, 3));
  stage.setTolerance(0.01);
  const auto fine = Case::run(stage, raster(rows, cloud));
  double worst = 0;
  forMovesOfPasses(fine, [&](const auto& a, const auto& b, const PointCL&) {
    for (int i = 0; i <= 10; ++i) {
      const Eigen::Vector3d p = a + (b - a) * (i / 10.0);
      if (p.head<2>().minCoeff() < 3 || p.head<2>().maxCoeff() > 27)
        continue;
      const double across = (b - a).template head<2>().norm() / (b - a).norm();
      const double error = p.z() - Freeform::tip(1.5, p.x(), p.y());
      worst = std::max(worst, std::abs(error) * across);
    }
  });
  EXPECT_LT(worst, 0.01 + 0.005); // the band, and what the model errs at most
}

TEST(BufferPoints, APlaneNeedsNone)
{
  Case c;
  c.cloud = surface({0, 0, 20, 4}, 0.05, [](double x, double) { return 0.3 * x; });
  CLCloud path;
  const double up = 1.5 * (std::sqrt(1.09) - 1);
  path.push_back(PointCL(3, 2, 0.9 + up));
  path.push_back(PointCL(17, 2, 5.1 + up));
  EXPECT_EQ(c.fine(path).size(), 2u);
}

TEST(BufferPoints, ItsOwnOutputNeedsNoMore)
{
  Case c;
  c.cloud = surface({9, 0, 33, 4}, 0.2, [](double x, double) {
    return 3 * std::floor(x / 8) + std::sin(x);
  });
  const auto once = c.fine();
  auto again = c.buffer();
  const auto twice = Case::run(again, once);
  EXPECT_GT(once.size(), 2 * c.coarse().size());
  EXPECT_LE(twice.size(), once.size() + once.size() / 100);
  EXPECT_EQ(again.getReport().get("raised_points"), 0);
}

TEST(BufferPoints, KeepsThePointsThatItIsGiven)
{
  Case c;
  c.cloud = sample(shapes()[1], 0.5, 2);
  c.step_over = 6;
  auto coarse = c.coarse();
  for (auto& p : coarse)
    p.feed = 123;
  const auto fine = c.fine(coarse);
  std::size_t at = 0;
  for (const auto& p : coarse) {
    while (at < fine.size() && (fine[at].x != p.x || fine[at].y != p.y ||
                                fine[at].z != p.z || fine[at].label != p.label))
      ++at;
    ASSERT_LT(at, fine.size()) << "a CL point is missing";
    EXPECT_EQ(fine[at].feed, 123.f);
  }
}

TEST(BufferPoints, PointsThatStandTooLowAreRaised)
{
  Case c;
  c.cloud = surface({0, 0, 20, 8}, 0.1, [](double, double) { return 2; });
  c.tool = Tool::flat(1, 3);
  CLCloud path;
  path.push_back(PointCL(5, 4, 1.5));
  path.push_back(PointCL(10, 4, 2));
  path.push_back(PointCL(15, 4, -7));
  auto stage = c.buffer();
  const auto fine = Case::run(stage, path);
  for (const auto& p : fine)
    EXPECT_FLOAT_EQ(p.z, 2);
  EXPECT_EQ(stage.getReport().get("raised_points"), 2);
  stage.setFloor(3);
  for (const auto& p : Case::run(stage, path))
    EXPECT_FLOAT_EQ(p.z, 3);
}

TEST(BufferPoints, HighPointsAreLeftWhereTheyAre)
{
  // A chord that stays high is split and follows the curve between its ends.
  Case c;
  c.cloud = surface({0, 0, 20, 8}, 0.1, [](double, double) { return 0; });
  CLCloud path;
  path.push_back(PointCL(5, 4, 3));
  path.push_back(PointCL(15, 4, 3));
  const auto fine = c.fine(path);
  EXPECT_EQ(fine.front().z, 3.f);
  EXPECT_EQ(fine.back().z, 3.f);
  EXPECT_GT(fine.size(), 10u);
}

TEST(BufferPoints, LabelsSeparatePasses)
{
  // From the end of one pass to the beginning of the next there is no chord.
  Case c;
  c.cloud = fin();
  CLCloud path;
  path.push_back(PointCL(5, 4, 0));
  path.push_back(PointCL(15, 4, 0));
  path[1].label = 1;
  const auto fine = c.fine(path);
  ASSERT_EQ(fine.size(), 2u);
  EXPECT_EQ(chords(fine), 0u);
  EXPECT_EQ(fine[1].label, 1u);
}

TEST(BufferPoints, InsertedPointsBelongToTheirPass)
{
  Case c;
  c.cloud = sample(shapes()[1], 0.5, 2);
  c.step_over = 6;
  const auto coarse = c.coarse(), fine = c.fine(coarse);
  for (std::size_t i = 1; i < fine.size(); ++i) {
    EXPECT_LE(fine[i].label - fine[i - 1].label, 1u);
    if (fine[i].label == fine[i - 1].label) {
      EXPECT_NEAR(fine[i].y, fine[i - 1].y, 1e-5);
    }
  }
  EXPECT_EQ(fine.back().label, coarse.back().label);
}

TEST(BufferPoints, WorksOnTheIndicesGiven)
{
  Case c;
  c.cloud = fin();
  CLCloud path;
  for (const double x : {5.0, 8.0, 12.0, 15.0})
    path.push_back(PointCL(x, 4, 0));
  auto stage = c.buffer();
  stage.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 1}));
  const auto left = Case::run(stage, path);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[1].x, 8.f);
  stage.setIndices(pcl::IndicesPtr(new pcl::Indices{0, 3}));
  const auto across = Case::run(stage, path);
  EXPECT_GT(across.size(), 4u);
  EXPECT_LE(deepest(across, c.tool, 0, pointsOf(*c.cloud)), 0.01 + kRounding);
}

TEST(BufferPoints, TheSurfacesNaNsAreIgnored)
{
  Case c;
  c.cloud = fin();
  const std::string clean = bytes(c.fine());
  Case dirty = c;
  dirty.cloud.reset(new Cloud(*c.cloud));
  dirty.cloud->push_back({std::nanf(""), 3, 50});
  dirty.cloud->push_back({3, 3, std::nanf("")});
  dirty.cloud->is_dense = false;
  EXPECT_EQ(bytes(dirty.fine(c.coarse())), clean);
}

TEST(BufferPoints, AreTheSameForAnyNumberOfThreads)
{
  Case c;
  c.cloud = sample(shapes()[3], 0.5, 4);
  const auto coarse = c.coarse();
  auto stage = c.buffer();
  stage.setNumberOfThreads(1);
  const std::string one = bytes(Case::run(stage, coarse));
  for (const unsigned threads : {2u, 5u}) {
    stage.setNumberOfThreads(threads);
    EXPECT_EQ(bytes(Case::run(stage, coarse)), one) << threads;
  }
}

TEST(BufferPoints, RefuseWhatTheyCannotJudge)
{
  Case c;
  c.cloud = fin();
  CLCloud output, path;
  output.push_back(PointCL(1, 2, 3));
  path.push_back(PointCL(5, 4, 0));
  path.push_back(PointCL(15, 4, std::nan("")));
  const auto expectRefused = [&](auto& stage, auto error, const char* why) {
    EXPECT_THROW(stage.filter(output), decltype(error)) << why;
    ASSERT_EQ(output.size(), 1u) << why;
    EXPECT_EQ(output[0].z, 3.f) << why;
  };
  auto stage = c.buffer();
  expectRefused(stage, DataError(""), "no input");
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud));
  expectRefused(stage, DataError(""), "empty input");
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  expectRefused(stage, DataError(""), "NaN in the path");
  path[1].z = 0;
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  stage.setTolerance(0);
  expectRefused(stage, ParameterError(""), "no tolerance");
  BufferPoints<pcl::PointXYZ> without;
  without.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  expectRefused(without, DataError(""), "no surface");
  without.setSurface(Cloud::ConstPtr(new Cloud));
  expectRefused(without, DataError(""), "an empty surface");
}
