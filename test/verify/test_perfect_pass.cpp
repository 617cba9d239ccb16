// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What a perfect pass leaves, against a tool that is dropped everywhere.
#include <perfect_pass.h>

#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

using namespace pointmill;
using namespace pointmill_test;

namespace {

const Rectangle kArea{0, 0, 5, 3};

/// Over each point, by brute force with the tip on a grid of `step` [mm].
std::vector<double> bruteHeights(const PointIndex& part,
                                 const PointIndex& points,
                                 const Tool& tool,
                                 double floor,
                                 double step,
                                 const KeepOut& keep_out = KeepOut())
{
  std::vector<double> heights(points.size(), 1e9);
  const double r = tool.radius();
  for (double y = part.min().y() - r; y <= part.max().y() + r; y += step)
    for (double x = part.min().x() - r; x <= part.max().x() + r; x += step) {
      const double tip =
          std::max({floor, part.drop(tool, x, y).tip, keep_out.lowest(tool, x, y)});
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d p = points.point(i);
        heights[i] =
            std::min(heights[i], tip + tool.profile(std::hypot(x - p.x(), y - p.y())));
      }
    }
  return heights;
}

/// Rough, with a slope of 60 degrees and a step.
Cloud::Ptr roughPart(double noise)
{
  Random random(5);
  return surface(kArea, 0.2, [&](double x, double y) {
    const double slope = 1.7 * std::min(std::abs(x - 1.5), 0.8);
    return slope + (x > 3.5 ? 1.0 : 0.0) + 0.2 * std::sin(3 * y) +
           noise * random.normal();
  });
}

} // namespace

TEST(PerfectPass, IsThatOfAToolThatRestsEverywhere)
{
  for (const double noise : {0.0, 0.05})
    for (const Tool& tool :
         {Tool::ball(1, 2), Tool::bull(2, 2, 0.4), Tool::flat(3, 2)}) {
      const auto part = indexOf(*roughPart(noise));
      const double floor = 0.1, close = 0.01;
      const auto heights = PerfectPass(*part, tool, floor, 2).heightsOver(*part, close);
      const auto fine = bruteHeights(*part, *part, tool, floor, 0.025);
      double excess = 0;
      std::size_t worse = 0;
      for (std::size_t i = 0; i < heights.size(); ++i) {
        const double z = part->point(i).z();
        // Never lower than any tool can be, but for what the brute force's grid misses.
        EXPECT_GE(heights[i], z - 1e-6);
        EXPECT_GE(heights[i], std::min(fine[i] - 0.1, z + close));
        const double over = heights[i] - std::max(fine[i], z);
        excess += std::max(0.0, over) / double(heights.size());
        worse += over > 2 * close;
      }
      SCOPED_TRACE(testing::Message() << tool.describe() << ", noise " << noise);
      // A flat's edge falls off the steps of rough ground: no search finds each of
      // them.
      EXPECT_LT(excess, tool.isFlat() ? 2 * close : close);
      EXPECT_LT(worse, heights.size() / (tool.isFlat() ? 4 : 10));
    }
}

TEST(PerfectPass, GoesOverOtherPointsThanThePart)
{
  // A plate at 0; points hang over it, lie on it and under it.
  const auto plate = indexOf(*surface(kArea, 0.2, [](double, double) { return 0; }));
  Cloud cloud;
  for (const float z : {0.5f, 0.f, -0.3f})
    cloud.push_back(pcl::PointXYZ(2, 2, z));
  const auto points = indexOf(cloud);
  const PerfectPass pass(*plate, Tool::ball(1, 2), -1, 2);
  const auto heights = pass.heightsOver(*points, 0.01);
  for (const float h : heights) // it sinks R - sqrt(R^2 - s^2 / 2) between the points
    EXPECT_NEAR(h, 0, 1 - std::sqrt(1 - 0.02));
}

TEST(PerfectPass, GoesNoLowerThanTheFloor)
{
  const auto plate = indexOf(*surface(kArea, 0.2, [](double, double) { return 0; }));
  const auto heights =
      PerfectPass(*plate, Tool::flat(1, 2), 0.4, 2).heightsOver(*plate, 0.01);
  for (const float h : heights)
    EXPECT_FLOAT_EQ(h, 0.4f);
}

TEST(PerfectPass, StaysAboveZones)
{
  const auto part = indexOf(*roughPart(0.0));
  const KeepOutZone clamp = KeepOutZone::box(2, -1, 2.6, 1.2, 1.0);
  // The lowest tip has a step at a zone's reach: what one search finds, another one
  // may find a node beside.
  const double margin = 0.3, beside = 0.15;
  for (const Tool& tool : {Tool::ball(1, 2), Tool::flat(2, 1)}) {
    const double floor = 0.1, close = 0.01;
    const auto heightsAt = [&](double m) {
      return bruteHeights(*part, *part, tool, floor, 0.05, KeepOut({clamp}, m));
    };
    const auto heights = PerfectPass(*part, tool, floor, 2, KeepOut({clamp}, margin))
                             .heightsOver(*part, close);
    const auto bare = PerfectPass(*part, tool, floor, 2).heightsOver(*part, close);
    const auto least = heightsAt(margin - beside), most = heightsAt(margin + beside);
    std::size_t lifted = 0;
    for (std::size_t i = 0; i < part->size(); ++i) {
      EXPECT_GE(heights[i], least[i] - 0.1) << part->point(i).transpose();
      // brute force may round a point at the very rim to outside of the tool
      EXPECT_LE(heights[i], std::max(most[i], part->point(i).z()) + 0.1)
          << part->point(i).transpose();
      lifted += heights[i] > bare[i] + 0.1;
    }
    EXPECT_GT(lifted, 10u);
  }
}

TEST(PerfectPass, IsTheSameForAnyNumberOfThreads)
{
  const auto part = indexOf(*roughPart(0.05));
  const Tool ball = Tool::ball(1, 1.5);
  EXPECT_EQ(PerfectPass(*part, ball, -9, 1).heightsOver(*part, 0.01),
            PerfectPass(*part, ball, -9, 5).heightsOver(*part, 0.01));
}
