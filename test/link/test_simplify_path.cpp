// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Fewer CL points, and nothing is lost by it.
#include "link_test.h"

#include <pointmill/link/simplify_path.h>
#include <pointmill_test/freeform.h>

using namespace link_test;

namespace {

constexpr double kRounding = 2e-6;

CLCloud simplify(SimplifyPath& stage, const CLCloud& path)
{
  CLCloud output;
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  stage.filter(output);
  return output;
}

SimplifyPath over(const std::shared_ptr<const PointIndex>& part, ToleranceBand band)
{
  SimplifyPath stage;
  stage.setPart(part, 0.0);
  stage.setTolerance(band);
  return stage;
}

/// A ball's path over the freeform along Y = y, `step` apart.
CLCloud freeformPath(double y, double step, std::uint32_t label)
{
  CLCloud path;
  for (double x = 2; x <= 38; x += step) {
    path.push_back(PointCL(x, y, Freeform::tip(1.5, x, y)));
    path.back().label = label;
  }
  return path;
}

/// Distance of @p p from the polyline of a path.
double distance(const CLCloud& path, const Eigen::Vector3d& p)
{
  double best = 1e9;
  forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
    const Eigen::Vector3d along = b - a;
    const double t =
        std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
    best = std::min(best, (p - a - t * along).norm());
  });
  return best;
}

std::shared_ptr<PointIndex> ground(double depth)
{
  auto cloud = Freeform::sample(60000, 40, 0, 1);
  for (auto& p : *cloud)
    p.z -= static_cast<float>(depth);
  return indexOf(*cloud);
}

} // namespace

TEST(SimplifyPath, LeavesAStraightPathItsEnds)
{
  CLCloud path;
  for (int i = 0; i <= 1000; ++i)
    path.push_back(PointCL(0.009 * i, 3 + 0.002 * i, 5 - 0.004 * i));
  const auto index =
      indexOf(*surface({0, 0, 10, 10}, 0.5, [](double, double) { return -1; }));
  auto stage = over(index, {1e-5, 1e-5});
  stage.setLongestChord(100);
  const CLCloud two = simplify(stage, path);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].x, path.front().x);
  EXPECT_EQ(two[1].z, path.back().z);
  EXPECT_EQ(stage.getReport().get("cl_points_in"), 1001);
  EXPECT_EQ(stage.getReport().get("cl_points"), 2);
  stage.setLongestChord(1.0);
  const CLCloud many = simplify(stage, path);
  EXPECT_GE(many.size(), 11u);
  EXPECT_LE(many.size(), 13u);
}

TEST(SimplifyPath, StaysWithinItsBandOfWhatItSkips)
{
  const auto far = ground(5); // nothing to gouge
  CLCloud path = freeformPath(11, 0.01, 0);
  for (const ToleranceBand band : {ToleranceBand{0.001, 0.02}, {0.02, 0.001}}) {
    auto stage = over(far, band);
    const CLCloud few = simplify(stage, path);
    EXPECT_LT(few.size(), 200u);
    double high = 0, low = 0;
    for (const auto& p : path) {
      const Eigen::Vector3d at(p.x, p.y, p.z);
      const double off = distance(few, at);
      // beneath or above: in the same plane, at the same X
      double z = 0;
      for (std::size_t i = 1; i < few.size(); ++i)
        if (few[i - 1].x <= p.x && p.x <= few[i].x)
          z = few[i - 1].z + (few[i].z - few[i - 1].z) * (p.x - few[i - 1].x) /
                                 std::max(1e-9f, few[i].x - few[i - 1].x);
      (z > p.z ? high : low) = std::max(z > p.z ? high : low, off);
    }
    EXPECT_LE(high, band.outside + kRounding);
    EXPECT_LE(low, band.inside + kRounding);
    EXPECT_GT(std::max(high, low), 0.8 * std::max(band.inside, band.outside));
  }
}

TEST(SimplifyPath, GivesTheFewestPoints)
{
  // By dynamic programming over all chords between the points.
  const auto far = ground(5);
  CLCloud path = freeformPath(7, 0.1, 0);
  const ToleranceBand band{0.01, 0.01};
  auto stage = over(far, band);
  stage.setLongestChord(1e4);
  const std::size_t n = path.size();
  std::vector<std::size_t> best(n, n);
  best[0] = 1;
  const auto place = [&](std::size_t i) {
    return Eigen::Vector3d(path[i].x, path[i].y, path[i].z);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      CLCloud chord;
      chord.push_back(path[i]);
      chord.push_back(path[j]);
      bool good = true;
      for (std::size_t k = i + 1; good && k < j; ++k)
        good = distance(chord, place(k)) <= 0.01;
      if (good)
        best[j] = std::min(best[j], best[i] + 1);
    }
  EXPECT_LE(simplify(stage, path).size(), best[n - 1] + 1);
  EXPECT_GE(simplify(stage, path).size(), best[n - 1]);
}

TEST(SimplifyPath, NoChordCutsIntoThePartMoreThanItMay)
{
  // The path lies on the ground: chords over its hills would cut them.
  const auto index = ground(0);
  brute::Points points;
  for (std::size_t i = 0; i < index->size(); ++i)
    points.push_back(index->point(i));
  const CLCloud path = freeformPath(11, 0.02, 0);
  for (const double inside : {0.0, 0.004}) {
    auto stage = over(index, {inside, 0.05});
    const CLCloud few = simplify(stage, path);
    EXPECT_LT(few.size(), inside > 0 ? path.size() / 4 : path.size());
    double worst = 0;
    forMovesOfPasses(few, [&](const auto& a, const auto& b, const PointCL&) {
      for (const auto& p : points)
        if (std::abs(p.y() - 11) < 1.5 && p.x() > a.x() - 1.5 && p.x() < b.x() + 1.5)
          worst = std::max(worst, brute::gouge(Tool::ball(1, 3), a, b, p, 40));
    });
    EXPECT_LE(worst, inside + 2e-5);
  }
}

TEST(SimplifyPath, KeepsWhatSetsPointsApart)
{
  CLCloud path;
  for (int i = 0; i <= 10; ++i)
    path.push_back(PointCL(i, 0, 1));
  for (int i = 4; i <= 10; ++i)
    path[i].feed = 500; // slower from 3 to 4 on
  path[8].setMotion(Motion::Ramp);
  path[10].label = 1;
  auto stage =
      over(indexOf(*surface({0, 0, 10, 10}, 1, [](double, double) { return 0; })),
           {0.01, 0.01});
  stage.setLongestChord(100);
  const CLCloud few = simplify(stage, path);
  std::vector<float> x;
  for (const auto& p : few)
    x.push_back(p.x);
  EXPECT_EQ(x, (std::vector<float>{0, 3, 7, 8, 9, 10}));
  EXPECT_EQ(few[2].feed, 500);
}

TEST(SimplifyPath, KeepsCornersAndVerticalMoves)
{
  CLCloud path;
  for (const auto& p : {PointCL(0, 0, 0),
                        PointCL(2, 0, 0),
                        PointCL(2, 0, 5),
                        PointCL(2.02, 0, 5),
                        PointCL(6, 0, 5),
                        PointCL(6, 4, 5)})
    path.push_back(p);
  auto stage =
      over(indexOf(*surface({0, 0, 10, 10}, 1, [](double, double) { return -3; })),
           {0.01, 0.01});
  const CLCloud few = simplify(stage, path);
  EXPECT_EQ(few.size(), 5u); // all but the one at 2.02
}

TEST(SimplifyPath, IsTheSameForAnyNumberOfThreadsAndLeavesItsOwnOutput)
{
  const auto index = ground(0);
  CLCloud path;
  for (std::uint32_t k = 0; k < 20; ++k)
    path += freeformPath(3 + k, 0.05, k);
  auto stage = over(index, {0.005, 0.005});
  stage.setNumberOfThreads(1);
  const CLCloud one = simplify(stage, path);
  stage.setNumberOfThreads(3);
  const CLCloud many = simplify(stage, path);
  EXPECT_EQ(bytes(one), bytes(many));
  EXPECT_EQ(one.back().label, 19u);
}

TEST(SimplifyPath, RefusesWhatItCannotJudge)
{
  CLCloud path, output;
  path.push_back(PointCL(0, 0, 1));
  path.push_back(PointCL(1, 0, 1));
  SimplifyPath without;
  without.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  EXPECT_THROW(without.filter(output), DataError);
  auto stage = over(ground(0), {-0.1, 0.01});
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  EXPECT_THROW(stage.filter(output), ParameterError);
  path[1].y = std::nanf("");
  auto nan = over(ground(0), {0.1, 0.01});
  nan.setInputCloud(CLCloud::ConstPtr(new CLCloud(path)));
  EXPECT_THROW(nan.filter(output), DataError);
}
