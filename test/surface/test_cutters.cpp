// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Every kind of cutter against closed forms and brute force.
#include <pointmill/surface/contact.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/stock_field.h>
#include <pointmill/surface/sweep.h>

#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>

using Eigen::Vector3d;
using pointmill::PointIndex;
using pointmill::Tool;
using pointmill_test::Random;

namespace pointmill {
void PrintTo(const Tool& tool, std::ostream* out)
{
  *out << tool.describe();
}
} // namespace pointmill

namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kPitch = 5e-4;   // of the points on a section
constexpr double kSampled = 6e-4; // an edge meets no point nearer than half a pitch
constexpr double kOutline =
    3e-4;                      // of a sampled outline: an edge lies between two places
constexpr double kReach = 9.0; // of the sections, beyond every tool and its place

class Cutters : public testing::TestWithParam<Tool> {};

INSTANTIATE_TEST_SUITE_P(Family,
                         Cutters,
                         testing::Values(Tool::flat(1, 4.0),
                                         Tool::ball(2, 3.0),
                                         Tool::bull(3, 5.0, 1.0),
                                         Tool::taperBall(4, 1.0, 5.0, 6.0),
                                         Tool::taperBall(5, 2.0, 30.0, 5.0),
                                         Tool::taperBull(6, 3.0, 0.5, 10.0, 5.0),
                                         Tool::cone(7, 30.0, 4.0),
                                         Tool::cone(8, 45.0, 6.0, 1.0),
                                         Tool::taperBall(9, 1.0, 20.0, 4.0).grown(0.3),
                                         Tool::cone(10, 60.0, 4.0, 0.4).grown(0.25)),
                         [](const auto& each) {
                           const std::string type = each.param.type();
                           return type + std::to_string(each.param.number);
                         });

/// The numbers that the closed forms are made of.
struct Shape {
  double flat, corner, sin, cos, radius, shoulder, shoulder_height;

  explicit Shape(const Tool& t)
      : flat(t.tipRadius() - t.corner_radius), corner(t.corner_radius),
        sin(std::sin(t.taper * kDegree)), cos(std::cos(t.taper * kDegree)),
        radius(t.radius()), shoulder(t.shoulder_radius),
        // the cone, sunk by `shoulder`, at the radius of the shoulder's centre
        shoulder_height(
            t.isTapered()
                ? corner + ((radius - shoulder - flat) * cos - corner + shoulder) / sin
                : HUGE_VAL)
  {
  }
  double shoulderCentre() const { return radius - shoulder; }

  /// Height of the tip over a plane of slope `tan(b)` under the axis: the rounding's
  /// centre is `corner` off the plane along the normal and `flat` uphill, so that
  /// (tip + corner - flat tan b) cos b = corner; on ground steeper than the cone the
  /// same for the shoulder.
  double overSlope(double b) const
  {
    const double tan = std::tan(b);
    if (sin == 0 || std::cos(b) >= sin)
      return flat * tan + corner * (1 / std::cos(b) - 1);
    return shoulderCentre() * tan + shoulder / std::cos(b) - shoulder_height;
  }

  /// Height of the tip over the centre of a sphere of radius `s`, `e` from the axis:
  /// centres of rounding and sphere are s + corner apart, or the cone's line is.
  double overSphere(double s, double e) const
  {
    if (e <= flat)
      return s;
    const double round = s + corner, u = e - flat;
    if (u <= round * cos)
      return std::sqrt(round * round - u * u) - corner;
    const double v = e - shoulderCentre();
    if (v <= (s + shoulder) * cos)
      return (round - u * cos) / sin - corner;
    return std::sqrt((s + shoulder) * (s + shoulder) - v * v) - shoulder_height;
  }
};

using Height = std::function<double(double, double)>;

/// The surface z(x, y) as points: closely along y = 0, where the tools of these tests
/// touch, at `edges` exactly, and some all round, which must not matter.
PointIndex pointsOf(const Height& z, const std::vector<double>& edges = {})
{
  std::vector<float> x, y, h;
  const auto add = [&](double at, double beside) {
    const auto fx = static_cast<float>(at), fy = static_cast<float>(beside);
    const double height = z(fx, fy);
    if (std::isnan(height))
      return;
    x.push_back(fx);
    y.push_back(fy);
    h.push_back(static_cast<float>(height));
  };
  for (double at = -kReach; at <= kReach; at += kPitch)
    add(at, 0);
  for (const double at : edges)
    add(at, 0);
  Random random(3);
  for (int i = 0; i < 4000; ++i)
    add(random.uniform(-kReach, kReach), random.uniform(-kReach, kReach));
  return PointIndex(std::move(x), std::move(y), std::move(h));
}

/// The outline as a polyline.
std::vector<Eigen::Vector2d> outlineOf(const Tool& tool)
{
  constexpr int many = 4000;
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i <= many; ++i) {
    const double s = double(i) / many; // denser where it is steep: at the rim
    const double r = tool.radius() * (1 - (1 - s) * (1 - s));
    outline.emplace_back(r, tool.profile(r));
  }
  return outline;
}

/// Depth inside the tool with its tip at the origin; negative outside.
double sampledDepth(const Tool& tool,
                    const std::vector<Eigen::Vector2d>& outline,
                    double r,
                    double z)
{
  double nearest2 = HUGE_VAL;
  for (std::size_t i = 1; i < outline.size(); ++i)
    for (const double side : {r, -r}) {
      const auto &a = outline[i - 1], &b = outline[i];
      nearest2 = std::min(
          nearest2, pointmill::segmentDistance2(a.x(), a.y(), b.x(), b.y(), side, z));
    }
  double nearest = std::sqrt(nearest2);
  if (z >= outline.back().y()) // beside the shank
    nearest = std::min(nearest, std::abs(tool.radius() - r));
  return z > tool.profile(r) ? nearest : -nearest;
}

} // namespace

TEST_P(Cutters, TheProfileIsContinuousConvexAndRising)
{
  const Tool& tool = GetParam();
  const Shape shape(tool);
  const int n = 100000;
  const double dr = tool.radius() / n;
  EXPECT_EQ(tool.profile(0), 0);
  EXPECT_TRUE(std::isinf(tool.profile(tool.radius() + 1e-9)));
  double before = 0, step_before = 0;
  for (int i = 1; i <= n; ++i) {
    const double h = tool.profile(std::min(i * dr, tool.radius())), step = h - before;
    ASSERT_GE(step, step_before - 1e-12) << i * dr; // no jump either, but at the rim
    before = h;
    step_before = step;
  }
  // The rim: of a cylindrical tool the corner's top, else where the cone ends.
  EXPECT_NEAR(tool.profile(tool.radius()),
              tool.isTapered() ? shape.shoulder_height : tool.corner_radius,
              1e-9);
  EXPECT_NEAR(before, tool.profile(tool.radius() - 1e-9), 1e-4);
}

TEST_P(Cutters, RoundingAndConeAreTangent)
{
  const Tool& tool = GetParam();
  if (!tool.isTapered())
    return;
  const Shape s(tool);
  // The normal at the joint leans by the cone's angle: centre + corner (cos, -sin).
  const double joint = s.flat + s.corner * s.cos;
  EXPECT_NEAR(tool.profile(joint), s.corner * (1 - s.sin), 1e-12);
  const double e = 1e-6, slope = s.cos / s.sin;
  EXPECT_NEAR((tool.profile(joint + e) - tool.profile(joint)) / e, slope, 1e-4 * slope);
  if (s.corner > 0) {
    EXPECT_NEAR(
        (tool.profile(joint) - tool.profile(joint - e)) / e, slope, 1e-3 * slope);
  }
  const double end = s.radius - s.shoulder + s.shoulder * s.cos;
  EXPECT_NEAR((tool.profile(end) - tool.profile(end - e)) / e, slope, 1e-4 * slope);
}

TEST_P(Cutters, SteepnessIsTheSlopesSine)
{
  const Tool& tool = GetParam();
  const double e = 1e-7;
  for (double r = 0.013; r < tool.radius() - 0.01; r += 0.0371) {
    const double slope = (tool.profile(r + e) - tool.profile(r - e)) / (2 * e);
    EXPECT_NEAR(tool.profile().steepness(r), slope / std::hypot(1, slope), 1e-5) << r;
  }
}

TEST_P(Cutters, RestsOnAPlane)
{
  const PointIndex plane = pointsOf([](double, double) { return 1.5; });
  for (const double x : {-1.0, 0.0, 0.3})
    EXPECT_NEAR(plane.drop(GetParam(), x, 0).tip, 1.5, kSampled);
}

TEST_P(Cutters, RestsOnASlope)
{
  const Tool& tool = GetParam();
  for (const double degrees : {10.0, 35.0, 52.0, 70.0, 84.0}) {
    const double b = degrees * kDegree, tan = std::tan(b);
    const PointIndex slope = pointsOf([&](double x, double) { return x * tan; });
    const auto contact = slope.drop(tool, 0, 0);
    const Shape s(tool);
    EXPECT_NEAR(contact.tip, s.overSlope(b), kSampled * std::max(1.0, tan)) << degrees;
    // Where the contact is on something round it shows the slope's own normal.
    const bool on_corner = tool.corner_radius > 0 && std::cos(b) > s.sin + 0.05;
    const bool on_shoulder = s.shoulder > 0 && std::cos(b) < s.sin - 0.05;
    if (on_corner || on_shoulder) {
      const Vector3d n = pointmill::contactNormal(tool, 0, 0, contact);
      const double tolerance = 2 * kPitch / (on_corner ? s.corner : s.shoulder) + 1e-4;
      EXPECT_NEAR(n.norm(), 1, 1e-12);
      EXPECT_NEAR(n.x(), -std::sin(b), tolerance) << degrees;
      EXPECT_NEAR(n.z(), std::cos(b), 20 * tolerance) << degrees;
    }
  }
}

TEST_P(Cutters, RestsOnASphere)
{
  const Tool& tool = GetParam();
  const double radius = 2.5;
  const PointIndex sphere = pointsOf([&](double x, double y) {
    const double d2 = x * x + y * y;
    return d2 <= radius * radius ? std::sqrt(radius * radius - d2) : std::nan("");
  });
  for (double e = 0; e < tool.radius() + radius - 0.05; e += 0.31)
    EXPECT_NEAR(sphere.drop(tool, e, 0).tip, Shape(tool).overSphere(radius, e), 4e-3)
        << e;
}

TEST_P(Cutters, RestsOnACone)
{
  // Its side is a slope, touched uphill of the axis; near the apex that is touched.
  const Tool& tool = GetParam();
  const double b = 40 * kDegree;
  const PointIndex cone = pointsOf(
      [&](double x, double y) { return -std::hypot(x, y) * std::tan(b); }, {0.0});
  for (double e = 0; e < 4; e += 0.23) {
    const double side = -e * std::tan(b) + Shape(tool).overSlope(b);
    const double apex = e <= tool.radius() ? -tool.profile(e) : -HUGE_VAL;
    const Shape s(tool);
    const bool steep = std::cos(b) < s.sin;
    const double touched = steep ? s.shoulderCentre() + s.shoulder * std::sin(b)
                                 : s.flat + s.corner * std::sin(b);
    EXPECT_NEAR(cone.drop(tool, e, 0).tip, e > touched ? side : apex, 2 * kSampled)
        << e;
  }
}

TEST_P(Cutters, RestsOnAStepsEdge)
{
  const Tool& tool = GetParam();
  const double depth = 1.2;
  const PointIndex step =
      pointsOf([&](double x, double) { return x <= 0 ? 0.0 : -depth; }, {0.0});
  for (double e = -1; e < tool.radius() + 0.5; e += 0.07)
    EXPECT_NEAR(step.drop(tool, e, 0).tip,
                e <= 0 ? 0.0 : std::max(-depth, -tool.profile(e)),
                1e-6)
        << e;
}

TEST_P(Cutters, RestsInGrooves)
{
  const Tool& tool = GetParam();
  for (const double degrees : {20.0, 45.0, 75.0}) {
    const double tan = std::tan(degrees * kDegree);
    const PointIndex v = pointsOf([&](double x, double) { return std::abs(x) * tan; });
    for (const double e : {0.0, 0.4}) // held by both flanks, or by the nearer one
      EXPECT_NEAR(v.drop(tool, e, 0).tip,
                  e * tan + Shape(tool).overSlope(degrees * kDegree),
                  kSampled * std::max(1.0, tan))
          << degrees;
  }
  const double depth = 2.0, half = 0.875; // a float
  const PointIndex square =
      pointsOf([&](double x, double) { return std::abs(x) < half ? -depth : 0.0; },
               {-half, half});
  for (const double e : {0.0, 0.25, 0.6}) // the nearer edge holds it, or the bottom
    EXPECT_NEAR(
        square.drop(tool, e, 0).tip, std::max(-depth, -tool.profile(half - e)), 1e-5);
}

TEST_P(Cutters, DepthIsTheDistanceToTheSurface)
{
  const Tool& tool = GetParam();
  const auto outline = outlineOf(tool);
  const auto profile = tool.profile();
  const double top = outline.back().y();
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const double r = random.uniform(0, 1.4 * tool.radius());
    const double z = random.uniform(-1, std::min(top, 2 * tool.diameter) + 1);
    EXPECT_NEAR(profile.depth(r, z), sampledDepth(tool, outline, r, z), kOutline)
        << r << " " << z;
  }
}

TEST_P(Cutters, PenetrationIsTheDeepestOfManySteps)
{
  const Tool& tool = GetParam();
  const auto outline = outlineOf(tool);
  Random random(12);
  const auto any = [&] { return random.uniform(-2, 2); };
  int hits = 0;
  for (int i = 0; i < 60; ++i) {
    const Vector3d a(any(), any(), any()), p(any(), any(), any() + 2);
    const Vector3d b(
        i % 7 ? any() : a.x(), i % 7 ? any() : a.y(), i % 3 ? any() : a.z());
    const auto depthAt = [&](double t) {
      const Vector3d tip = a + t * (b - a);
      return sampledDepth(tool, outline, (p - tip).head<2>().norm(), p.z() - tip.z());
    };
    double deepest = -HUGE_VAL;
    constexpr int steps = 150;
    for (int k = 0; k <= steps; ++k)
      deepest = std::max(deepest, depthAt(double(k) / steps));
    const double exact = pointmill::penetration(tool, a, b, p);
    const double inside = std::max(0.0, deepest);
    EXPECT_GE(std::max(0.0, exact), inside - kOutline) << i;
    EXPECT_LE(exact, inside + (b - a).norm() / steps + kOutline) << i;
    hits += deepest > 0.05;
  }
  EXPECT_GE(hits, 10);
}

TEST_P(Cutters, SweptHeightIsTheLowestOfManySteps)
{
  const Tool& tool = GetParam();
  Random random(13);
  const auto any = [&] { return random.uniform(-4, 4); };
  int over = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector3d a(any(), any(), any());
    const bool plunge = i % 9 == 0, level = i % 5 == 0;
    const Vector3d b(
        plunge ? a.x() : any(), plunge ? a.y() : any(), level ? a.z() : any());
    const double x = any(), y = any();
    const auto heightAt = [&](double t) {
      const Vector3d tip = a + t * (b - a);
      return tip.z() + tool.profile(std::hypot(x - tip.x(), y - tip.y()));
    };
    // Lowest of equal steps, then of steps between the neighbours of that one: the
    // height is convex along the move.
    double from = 0, to = 1, lowest = HUGE_VAL;
    for (int round = 0; round < 4; ++round) {
      constexpr int steps = 1000;
      int best = 0;
      for (int k = 0; k <= steps; ++k) {
        const double h = heightAt(from + (to - from) * k / steps);
        if (h < lowest) {
          lowest = h;
          best = k;
        }
      }
      const double width = (to - from) / steps, middle = from + best * width;
      from = std::max(0.0, middle - width);
      to = std::min(1.0, middle + width);
    }
    const double exact = pointmill::sweptHeight(tool, a, b, x, y);
    if (std::isinf(lowest))
      continue; // the steps may miss a graze
    ++over;
    EXPECT_LE(exact, lowest + 1e-9) << i;
    // a place that is only grazed has its lowest at the edge of what the steps see
    const double d =
        std::sqrt(pointmill::segmentDistance2(a.x(), a.y(), b.x(), b.y(), x, y));
    if (d < 0.99 * tool.radius()) {
      EXPECT_NEAR(exact, lowest, 1e-6) << i;
    }
  }
  EXPECT_GT(over, 80);
}

TEST_P(Cutters, GrownIsTheOffsetSolid)
{
  const Tool& tool = GetParam();
  const double allowance = 0.35;
  const Tool grown = tool.grown(allowance);
  const auto outline = outlineOf(tool);
  for (double r = 0; r < grown.radius(); r += 0.083) // its tip is `allowance` lower
    EXPECT_NEAR(sampledDepth(tool, outline, r, grown.profile(r) - allowance),
                -allowance,
                kOutline)
        << r;
  EXPECT_NEAR(grown.radius(), tool.radius() + allowance, 1e-12);
  const Tool twice = tool.grown(0.15).grown(0.2);
  for (double r = 0; r < grown.radius(); r += 0.083)
    EXPECT_NEAR(twice.profile(r), grown.profile(r), 1e-9) << r;
}

TEST_P(Cutters, GrownLeavesTheAllowanceAlongTheNormal)
{
  const Tool& tool = GetParam();
  const double allowance = 0.35;
  const Tool grown = tool.grown(allowance);
  for (const double degrees : {0.0, 35.0, 70.0}) { // straight up it is a / cos
    const double b = degrees * kDegree;
    const PointIndex slope =
        pointsOf([&](double x, double) { return x * std::tan(b); });
    EXPECT_NEAR(slope.drop(grown, 0, 0).tip + allowance - slope.drop(tool, 0, 0).tip,
                allowance / std::cos(b),
                2 * kSampled * std::max(1.0, std::tan(b)))
        << degrees;
  }
  const double radius = 2.5; // a sphere that is thicker by the allowance
  const PointIndex sphere = pointsOf([&](double x, double y) {
    const double d2 = x * x + y * y;
    return d2 <= radius * radius ? std::sqrt(radius * radius - d2) : std::nan("");
  });
  for (double e = 0; e < tool.radius() + radius - 0.05; e += 0.31)
    EXPECT_NEAR(sphere.drop(grown, e, 0).tip + allowance,
                Shape(tool).overSphere(radius + allowance, e),
                4e-3)
        << e;
}

TEST_P(Cutters, TheUpperBoundOfTheStockHolds)
{
  const Tool& tool = GetParam();
  using pointmill::StockField;
  StockField upper({{0, 0, -6}, {8, 8, 0}}, 0.25, StockField::Bound::Upper);
  const Vector3d a(1, 2, -1), b(6, 5, -3);
  upper.cut(tool, a, b);
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(0, 8), y = random.uniform(0, 8);
    const double stands = std::min(0.0, pointmill::sweptHeight(tool, a, b, x, y));
    EXPECT_GE(upper.highest(x, y, 0), stands - 1e-6) << x << " " << y;
  }
  EXPECT_LT(upper.height(14, 14), -1); // and something was cut
}
