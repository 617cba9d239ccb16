// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cell_sort.h"
#include "search.h"

#include <pointmill/surface/sweep.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using Eigen::Vector2d;
using Eigen::Vector3d;
using pointmill::CellSort;
using pointmill::Contact;
using pointmill::HeightPyramid;
using pointmill::SortedPoints;
using pointmill::Tool;
using pointmill_test::Random;

namespace {

constexpr double kSize = 40;

double ground(double x, double y)
{
  return 3 * std::sin(x / 4) * std::cos(y / 5) + (x + y > 50 ? 5 : 0) +
         (x < 8 ? -std::floor(y) : 0);
}

/// Random points of the ground, sorted, under a pyramid.
struct Ground {
  std::vector<float> x, y, z;
  std::shared_ptr<HeightPyramid> pyramid;
  SortedPoints points;

  explicit Ground(int count)
  {
    Random random(21);
    for (int i = 0; i < count; ++i) {
      x.push_back(float(random.uniform(0, kSize)));
      y.push_back(float(random.uniform(0, kSize)));
      z.push_back(float(ground(x.back(), y.back())));
    }
    CellSort sort({{{x.data(), y.data(), z.data()}, 1, nullptr, z.size()}}, 1);
    pyramid = std::make_shared<HeightPyramid>(sort.points().frame);
    points = sort.run([&](int a, int b) { pyramid->addRows(sort.points(), a, b); });
    pyramid->finish();
  }
};

const std::vector<Tool> kTools{Tool::flat(1, 4.0),
                               Tool::ball(2, 3.0),
                               Tool::bull(3, 5.0, 1.0),
                               Tool::ball(4, 0.3),
                               Tool::bull(5, 20.0, 3.0),
                               Tool::taperBall(6, 1.0, 5.0, 6.0),
                               Tool::taperBull(7, 3.0, 0.5, 10.0, 8.0),
                               Tool::cone(8, 15.0, 3.0, 0.2).grown(0.2)};

} // namespace

TEST(Search, EveryInstructionSetGivesTheSameBits)
{
  const auto& versions = pointmill::searches();
  ASSERT_FALSE(versions.empty());
  RecordProperty("best", versions.back().name);
  const Ground ground(60000);
  const pointmill::SearchSpace space{ground.points, *ground.pyramid};
  Random random(22);
  const auto place = [&] {
    return Vector2d(random.uniform(-2, kSize + 2), random.uniform(-2, kSize + 2));
  };
  for (const Tool& tool : kTools)
    for (int i = 0; i < 40; ++i) {
      const Vector2d from = place(), to = place(), step = (to - from) / 100;
      const Vector2d near = from + 0.02 * (to - from);
      std::vector<Contact> truth(101), row(101);
      versions[0].drop_row(space, tool, from, step, truth.size(), truth.data());
      const Vector3d a(from.x(), from.y(), truth[0].tip - 0.1),
          b(near.x(), near.y(), truth[2].tip - 0.05);
      for (const auto& version : versions) {
        version.drop_row(space, tool, from, step, row.size(), row.data());
        for (std::size_t k = 0; k < row.size(); ++k) {
          ASSERT_EQ(row[k].tip, truth[k].tip) << version.name << tool.describe();
          ASSERT_EQ(row[k].point, truth[k].point) << version.name << tool.describe();
        }
        EXPECT_EQ(version.drop_along(space, tool, from, near),
                  versions[0].drop_along(space, tool, from, near))
            << version.name;
        EXPECT_EQ(version.gouge(space, tool, a, b, 0.01),
                  versions[0].gouge(space, tool, a, b, 0.01))
            << version.name;
      }
    }
}

TEST(Search, FindsTheDeepestGougeOfSlantedMovesAndPlunges)
{
  const Ground ground(20000);
  const pointmill::SearchSpace space{ground.points, *ground.pyramid};
  Random random(23);
  int hits = 0;
  for (const Tool& tool : kTools)
    for (int i = 0; i < 30; ++i) {
      const Vector2d from(random.uniform(0, kSize), random.uniform(0, kSize));
      const double length = i % 5 == 0 ? 0.0 : i % 3 ? 0.2 : 3.0; // some plunge
      const Vector2d to = from + length * Vector2d(random.normal(), random.normal());
      // near where the tool rests, so that the little that is inside counts
      std::vector<Contact> ends(2);
      pointmill::searches().back().drop_row(
          space, tool, from, to - from, ends.size(), ends.data());
      if (!ends[0].touches() || !ends[1].touches())
        continue;
      const Vector3d a(from.x(), from.y(), ends[0].tip - random.uniform(-0.05, 0.1));
      const Vector3d b(to.x(), to.y(), ends[1].tip - random.uniform(-0.05, 0.1));
      double truth = 0;
      for (std::size_t k = 0; k < ground.points.size(); ++k)
        truth =
            std::max(truth,
                     pointmill::penetration(
                         tool,
                         a,
                         b,
                         {ground.points.x[k], ground.points.y[k], ground.points.z[k]}));
      const double tolerance = 0.02;
      for (const auto& version : pointmill::searches())
        EXPECT_EQ(version.gouge(space, tool, a, b, tolerance),
                  truth > tolerance ? truth : 0.0)
            << version.name << ", " << tool.describe();
      hits += truth > tolerance;
    }
  EXPECT_GT(hits, 30);
}

TEST(Search, NoPointIsAboveThePlanesOfThePyramid)
{
  const Ground ground(30000);
  const SortedPoints& points = ground.points;
  const auto& frame = points.frame;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (int k = 0; k < ground.pyramid->levels(); ++k) {
      const auto& level = ground.pyramid->level(k);
      const int i = frame.column(points.x[p]) >> 2 * k,
                j = frame.row(points.y[p]) >> 2 * k;
      const std::size_t node = level.node(i, j);
      ASSERT_GE(level.top[node], points.z[p]);
      const auto& slopes = ground.pyramid->level(std::max(1, k));
      const std::size_t from = k > 0 ? node : slopes.node(i >> 2, j >> 2);
      const double x = points.x[p] - frame.x0 - (i + 0.5) * level.size;
      const double y = points.y[p] - frame.y0 - (j + 0.5) * level.size;
      const double plane =
          level.mid[node] + slopes.slope_x[from] * x + slopes.slope_y[from] * y;
      ASSERT_GE(plane, points.z[p] - 1e-9) << "level " << k;
    }
}
