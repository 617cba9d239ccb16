// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Boundaries against closed forms, and rows that keep to them.
#include "finish_test.h"

#include <pointmill/finish/boundary.h>
#include <pointmill/surface/sweep.h>

#include <map>

using namespace finish_test;
using Eigen::Vector2d;

namespace {

const std::vector<Vector2d> kBox{{2, 1}, {12, 1}, {12, 7}, {2, 7}};
/// An arrow's head; the corner at (4, 5) points inwards.
const std::vector<Vector2d> kArrow{{0, 0}, {14, 5}, {0, 10}, {4, 5}};
/// Crosses itself; by the even-odd rule the middle is outside.
const std::vector<Vector2d> kStar{{5, 10}, {8, 1}, {0, 6.5}, {10, 6.5}, {2, 1}};

double distanceToEdges(const std::vector<Vector2d>& polygon, const Vector2d& p)
{
  double nearest = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    nearest = std::min(
        nearest, std::sqrt(segmentDistance2(a.x(), a.y(), b.x(), b.y(), p.x(), p.y())));
  }
  return nearest;
}

bool evenOdd(const std::vector<Vector2d>& polygon, const Vector2d& p)
{
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      odd = !odd;
  }
  return odd;
}

/// Greater than 0 inside.
double depth(const std::vector<Vector2d>& polygon, double overhang, const Vector2d& p)
{
  const double d = distanceToEdges(polygon, p);
  return (evenOdd(polygon, p) ? d : -d) + overhang;
}

void expectSpan(const Span& span, double first, double last)
{
  EXPECT_NEAR(span.first, first, 1e-7);
  EXPECT_NEAR(span.last, last, 1e-7);
}

} // namespace

TEST(Boundary, OfABoxGrowsWithRoundCorners)
{
  const Boundary grown(kBox, 1.5);
  auto spans = grown.inside({0, 4}, {1, 0});
  ASSERT_EQ(spans.size(), 1u);
  expectSpan(spans[0], 0.5, 13.5);
  // 0.9 beside the lower edge the corners' circles of radius 1.5 reach 1.2 further.
  spans = grown.inside({0, 0.1}, {1, 0});
  ASSERT_EQ(spans.size(), 1u);
  expectSpan(spans[0], 2 - 1.2, 12 + 1.2);
  EXPECT_TRUE(grown.inside({0, -0.51}, {1, 0}).empty());
  expectSpan(grown.extent({0, 1}), -0.5, 8.5);
}

TEST(Boundary, HoldsTheLinesAlongItsOwnEdges)
{
  for (const double overhang : {-0.7, 0.0, 1.5})
    for (const double y : {1 - overhang, 7 + overhang}) {
      const auto spans = Boundary(kBox, overhang).inside({0, y}, {1, 0});
      ASSERT_EQ(spans.size(), 1u) << overhang << " " << y;
      EXPECT_NEAR(spans[0].first, 2 - std::min(0.0, overhang), 1e-4);
      EXPECT_NEAR(spans[0].last, 12 + std::min(0.0, overhang), 1e-4);
    }
}

TEST(Boundary, ShrinksByANegativeOverhang)
{
  const Boundary shrunk(kBox, -1);
  const auto spans = shrunk.inside({0, 4}, {1, 0});
  ASSERT_EQ(spans.size(), 1u);
  expectSpan(spans[0], 3, 11);
  EXPECT_TRUE(shrunk.inside({0, 1.9}, {1, 0}).empty());
  EXPECT_TRUE(Boundary(kBox, -3.1).inside({0, 4}, {1, 0}).empty());
}

TEST(Boundary, OfAnyPolygonIsWhatDistanceAndEvenOddRuleSay)
{
  Random random(3);
  std::size_t inside = 0, outside = 0;
  for (const auto& polygon : {kBox, kArrow, kStar})
    for (const double overhang : {-0.6, 0.0, 0.8})
      for (int i = 0; i < 60; ++i) {
        const double turn = random.uniform(0, 2 * M_PI);
        const Vector2d direction(std::cos(turn), std::sin(turn));
        const Vector2d origin(random.uniform(-2, 14), random.uniform(-2, 12));
        const auto spans = Boundary(polygon, overhang).inside(origin, direction);
        for (std::size_t k = 0; k < spans.size(); ++k) {
          EXPECT_LE(spans[k].first, spans[k].last);
          if (k > 0) {
            EXPECT_GT(spans[k].first, spans[k - 1].last);
          }
        }
        for (double t = -20; t < 20; t += 0.173) {
          const double by = depth(polygon, overhang, origin + t * direction);
          if (std::abs(by) < 1e-6)
            continue;
          bool held = false;
          for (const auto& s : spans)
            held = held || (t >= s.first && t <= s.last);
          EXPECT_EQ(held, by > 0) << overhang << " " << t;
          ++(held ? inside : outside);
        }
      }
  EXPECT_GT(inside, 5000u);
  EXPECT_GT(outside, 5000u);
}

TEST(Boundary, RefusesWhatIsNoPolygon)
{
  EXPECT_THROW(Boundary({{0, 0}, {1, 1}}, 0), ParameterError);
  EXPECT_THROW(Boundary({{0, 0}, {1, std::nan("")}, {0, 1}}, 0), ParameterError);
}

TEST(RowsInABoundary, EndExactlyAtIt)
{
  const auto cloud = surface({-5, -5, 25, 20}, 0.5, [](double, double) { return 3; });
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(Tool::ball(1, 4));
  stage.setStepOver(0.7);
  stage.setForwardStep(0.9);
  for (const double degrees : {0.0, 90.0, 30.0})
    for (const double overhang : {-0.6, 0.0, 0.8}) {
      stage.setAngle(degrees);
      stage.setBoundary(kArrow);
      stage.setOverhang(overhang);
      const auto path = raster(stage, cloud);
      std::map<std::uint32_t, std::pair<PointCL, PointCL>> ends;
      for (const auto& p : path) {
        EXPECT_GE(depth(kArrow, overhang, Vector2d(p.x, p.y)), -3e-6);
        ends.emplace(p.label, std::make_pair(p, p)).first->second.second = p;
      }
      EXPECT_GT(ends.size(), 9u);
      for (const auto& [label, pass] : ends)
        for (const auto& p : {pass.first, pass.second})
          EXPECT_NEAR(depth(kArrow, overhang, Vector2d(p.x, p.y)), 0, 3e-6) << label;
    }
}

TEST(RowsInABoundary, OfTheStockStayOverIt)
{
  const auto cloud = surface({0, 0, 20, 12}, 0.5, [](double, double) { return 3; });
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(Tool::ball(1, 4));
  stage.setBoundary(Stock{{1, 2, 0}, {19, 11, 5}});
  float x0 = 99, x1 = -99, y0 = 99, y1 = -99;
  for (const auto& p : raster(stage, cloud)) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
  EXPECT_FLOAT_EQ(x0, 1);
  EXPECT_FLOAT_EQ(x1, 19);
  EXPECT_FLOAT_EQ(y0, 2);
  EXPECT_FLOAT_EQ(y1, 11);
}

TEST(RowsInABoundary, ThatIsBesideThePartAreNone)
{
  const auto cloud = surface({0, 0, 20, 12}, 0.5, [](double, double) { return 3; });
  CLSurface<pcl::PointXYZ> stage;
  stage.setBoundary({{30, 0}, {40, 0}, {40, 10}});
  EXPECT_TRUE(raster(stage, cloud).empty());
}
