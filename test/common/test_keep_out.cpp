// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <brute_force.h>
#include <pointmill/common/error.h>
#include <pointmill/common/keep_out.h>

#include <gtest/gtest.h>

#include <random>

using Eigen::Vector2d;
using Eigen::Vector3d;
using pointmill::KeepOut;
using pointmill::KeepOutZone;
using pointmill::Tool;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTop = 6.0;

const Tool kTools[] = {Tool::flat(1, 6.0),
                       Tool::ball(2, 6.0),
                       Tool::bull(3, 6.0, 1.0),
                       Tool::taperBall(4, 1.0, 10.0, 6.0),
                       Tool::taperBull(5, 2.0, 0.5, 20.0, 6.0),
                       Tool::cone(6, 30.0, 6.0, 0.5)};

// An L, which is not convex.
const std::vector<Vector2d> kL = {{0, 0}, {9, 0}, {9, 3}, {4, 3}, {4, 8}, {0, 8}};

struct Shape {
  const char* name;
  KeepOutZone zone;
  bool (*holds)(double x, double y); // the shape, said in another way
};

const Shape kShapes[] = {
    {"box",
     KeepOutZone::box(7, 5, -1, 1, kTop),
     [](double x, double y) { return x >= -1 && x <= 7 && y >= 1 && y <= 5; }},
    {"cylinder",
     KeepOutZone::cylinder(3, 4, 2.5, kTop),
     [](double x, double y) { return std::hypot(x - 3, y - 4) <= 2.5; }},
    {"polygon", KeepOutZone::polygon(kL, kTop), [](double x, double y) {
       return x >= 0 && y >= 0 && ((x <= 9 && y <= 3) || (x <= 4 && y <= 8));
     }}};

constexpr double kApart = 0.05;

// Points over the top of the zone grown by `margin`: whatever is below them is less
// deep in a tool.
brute::Points sample(const Shape& shape, double margin)
{
  std::vector<Vector2d> inside;
  for (double x = -2; x <= 10; x += kApart)
    for (double y = -1; y <= 9; y += kApart)
      if (shape.holds(x, y))
        inside.push_back({x, y});
  brute::Points points;
  if (margin == 0) {
    for (const auto& p : inside)
      points.push_back({p.x(), p.y(), kTop});
    return points;
  }
  const int n = static_cast<int>(margin / kApart) + 1;
  std::vector<Vector2d> disc;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      if (std::hypot(i, j) * kApart <= margin)
        disc.push_back({i * kApart, j * kApart});
  const int columns = 400, rows = 400;
  std::vector<char> grown(columns * rows, 0);
  for (const auto& p : inside)
    for (const auto& d : disc) {
      const int c = static_cast<int>(std::lround((p.x() + d.x() + 5) / kApart));
      const int r = static_cast<int>(std::lround((p.y() + d.y() + 5) / kApart));
      grown[r * columns + c] = 1;
    }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      if (grown[r * columns + c])
        points.push_back({c * kApart - 5, r * kApart - 5, kTop + margin});
  return points;
}

Vector3d somewhere(std::mt19937& random)
{
  std::uniform_real_distribution<double> xy(-6, 14), z(0, 8);
  const double x = xy(random), y = xy(random);
  return {x, y, z(random)};
}

// The lowest clear tip for zones that are known by points at most `apart` off: the true
// one, were the zone smaller and larger by that.
void expectLowest(double lowest, const KeepOut& keep, const Tool& tool, double distance)
{
  const auto at = [&](double d) {
    const double h = tool.profile(std::max(0.0, d));
    return std::isinf(h) ? -kInfinity : kTop + keep.margin() - h;
  };
  EXPECT_LE(lowest, at(distance - 2 * kApart));
  EXPECT_GE(lowest, at(distance));
}

} // namespace

TEST(KeepOutZone, DistancesAreThoseOfASampledShape)
{
  std::mt19937 random(1);
  for (const auto& shape : kShapes) {
    const auto points = sample(shape, 0);
    for (int k = 0; k < 40; ++k) {
      const Vector3d a = somewhere(random), b = somewhere(random);
      const Vector2d low = a.cwiseMin(b).head<2>(), high = a.cwiseMax(b).head<2>();
      double here = kInfinity, along = kInfinity, over = kInfinity;
      for (const auto& p : points) {
        const Vector2d q = p.head<2>();
        here = std::min(here, (q - a.head<2>()).norm());
        const Vector2d ab = (b - a).head<2>();
        const double t =
            std::clamp((q - a.head<2>()).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        along = std::min(along, (a.head<2>() + t * ab - q).norm());
        over = std::min(over, (q.cwiseMax(low).cwiseMin(high) - q).norm());
      }
      const auto near = [&](double exact, double sampled) {
        EXPECT_LE(exact, sampled + 1e-9) << shape.name;
        EXPECT_GE(exact, sampled - 2 * kApart) << shape.name;
      };
      near(shape.zone.distance(a.x(), a.y()), here);
      near(shape.zone.distanceAlong(a.x(), a.y(), b.x(), b.y()), along);
      near(shape.zone.distanceOver(low, high), over);
    }
  }
}

TEST(KeepOutZone, InsideAllDistancesAreZero)
{
  const auto l = KeepOutZone::polygon(kL, kTop);
  EXPECT_EQ(l.distance(1, 1), 0);
  EXPECT_EQ(l.distanceAlong(1, 1, 2, 2), 0);        // wholly inside
  EXPECT_EQ(l.distanceAlong(-5, 1, 20, 1.5), 0);    // right through
  EXPECT_EQ(l.distanceOver({-5, -5}, {20, 20}), 0); // all round it
  EXPECT_EQ(l.distanceOver({1, 1}, {2, 2}), 0);
  // into the corner that is not part of it
  EXPECT_DOUBLE_EQ(l.distance(6, 5), 2.0);
  EXPECT_DOUBLE_EQ(l.distanceOver({6, 6}, {8, 8}), 2.0);
  EXPECT_DOUBLE_EQ(KeepOutZone::cylinder(0, 0, 2, 1).distance(3, 4), 3.0);
}

TEST(KeepOutZone, RefusesWhatIsNoZone)
{
  const double inf = kInfinity;
  EXPECT_THROW(KeepOutZone::box(0, 0, 0, 5, 1).validate(), pointmill::ParameterError);
  EXPECT_THROW(KeepOutZone::box(0, 0, inf, 5, 1).validate(), pointmill::ParameterError);
  EXPECT_THROW(KeepOutZone::cylinder(0, 0, 0, 1).validate(), pointmill::ParameterError);
  EXPECT_THROW(KeepOutZone::cylinder(0, 0, 1, std::nan("")).validate(),
               pointmill::ParameterError);
  const auto refused = [](std::vector<Vector2d> corners) {
    EXPECT_THROW(KeepOutZone::polygon(std::move(corners), 1).validate(),
                 pointmill::ParameterError);
  };
  refused({{0, 0}, {1, 0}});
  refused({{0, 0}, {1, 0}, {2, 0}});                         // no area
  refused({{0, 0}, {2, 2}, {2, 0}, {0, 2}});                 // a bow tie
  refused({{0, 0}, {2, 0}, {2, 0}, {0, 2}});                 // a corner twice
  refused({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});         // touches itself
  refused({{0, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}); // a spike
  KeepOutZone::polygon(kL, 1).validate();
  KeepOutZone::polygon({kL.rbegin(), kL.rend()}, 1).validate();
  EXPECT_THROW(KeepOut({}, -1.0), pointmill::ParameterError);
  EXPECT_THROW(KeepOut({KeepOutZone::box(0, 0, 0, 0, 1)}), pointmill::ParameterError);
}

TEST(KeepOut, NoZonesAllowEverything)
{
  const KeepOut none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.lowest(kTools[0], 0, 0), -kInfinity);
  EXPECT_EQ(none.highestTop(), -kInfinity);
  EXPECT_EQ(none.depth(kTools[0], {0, 0, 0}, {1, 1, 1}), 0);
}

TEST(KeepOut, TheLowestTipIsThatOverTheSampledZone)
{
  std::mt19937 random(2);
  const double margin = 0.5;
  for (const auto& shape : kShapes) {
    const KeepOut keep({shape.zone}, margin);
    const auto points = sample(shape, margin);
    for (const auto& tool : kTools)
      for (int k = 0; k < 25; ++k) {
        const Vector3d a = somewhere(random), b = somewhere(random);
        const Vector2d low = a.cwiseMin(b).head<2>(), high = a.cwiseMax(b).head<2>();
        double here = kInfinity, along = kInfinity, over = kInfinity;
        const Vector2d ab = (b - a).head<2>();
        for (const auto& p : points) {
          const Vector2d q = p.head<2>();
          here = std::min(here, (q - a.head<2>()).norm());
          const double t =
              std::clamp((q - a.head<2>()).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
          along = std::min(along, (a.head<2>() + t * ab - q).norm());
          over = std::min(over, (q.cwiseMax(low).cwiseMin(high) - q).norm());
        }
        SCOPED_TRACE(shape.name + (" " + tool.describe()));
        expectLowest(keep.lowest(tool, a.x(), a.y()), keep, tool, here);
        expectLowest(
            keep.lowestAlong(tool, a.x(), a.y(), b.x(), b.y()), keep, tool, along);
        expectLowest(keep.lowestOver(tool, low, high), keep, tool, over);
      }
  }
}

TEST(KeepOut, DepthIsThatOfTheDeepestPoint)
{
  std::mt19937 random(3);
  const double margin = 0.5;
  int deep = 0;
  for (const auto& shape : kShapes) {
    const KeepOut keep({shape.zone}, margin);
    const auto points = sample(shape, margin);
    for (const auto& tool : kTools)
      for (int k = 0; k < 24; ++k) {
        const Vector3d a = somewhere(random);
        Vector3d b = somewhere(random);
        if (k % 3 == 0)
          b.z() = a.z();
        if (k % 3 == 1)
          b.head<2>() = a.head<2>();
        double truth = 0;
        constexpr int steps = 100;
        for (int i = 0; i <= steps; ++i) {
          const Vector3d t = a + (b - a) * (double(i) / steps);
          // Depth falls with the distance: of all points the nearest is deepest.
          const Vector3d* nearest = nullptr;
          double distance = kInfinity;
          for (const auto& p : points) {
            const double d = (p - t).head<2>().squaredNorm();
            if (d < distance)
              distance = d, nearest = &p;
          }
          truth = std::max(
              truth, tool.profile().depth(std::sqrt(distance), nearest->z() - t.z()));
        }
        SCOPED_TRACE(shape.name + (" " + tool.describe()));
        const double depth = keep.depth(tool, a, b);
        const double step = (b - a).norm() / steps;
        EXPECT_GE(depth, truth - 1e-9 - 0.71 * kApart); // the grid is rounded to nodes
        EXPECT_LE(depth, truth + 2 * kApart + step);
        EXPECT_EQ(keep.enters(tool, a, b), depth > 0);
        deep += depth > 0.3;
      }
  }
  EXPECT_GT(deep, 50); // the test tests something
}

TEST(KeepOut, ATipAtTheLowestHeightIsClearAndBelowItIsNot)
{
  std::mt19937 random(4);
  for (const auto& shape : kShapes) {
    const KeepOut keep({shape.zone}, 0.7);
    for (const auto& tool : kTools)
      for (int k = 0; k < 200; ++k) {
        Vector3d a = somewhere(random), b = somewhere(random);
        const double low = keep.lowestAlong(tool, a.x(), a.y(), b.x(), b.y());
        if (!std::isfinite(low))
          continue;
        a.z() = b.z() = low + 1e-9;
        EXPECT_NEAR(keep.depth(tool, a, b), 0, 1e-12);
        a.z() = b.z() = low - 0.01;
        EXPECT_GT(keep.depth(tool, a, b), 0);
      }
  }
}

TEST(KeepOut, KnownDepths)
{
  const KeepOut bare({KeepOutZone::box(0, 0, 10, 10, 5)}, 0.0);
  const Tool flat = Tool::flat(1, 6.0);
  // Beside the wall the overlap, however deep down.
  EXPECT_DOUBLE_EQ(bare.depth(flat, {-2, -9, -50}, {-2, 20, -50}), 1.0);
  // Over it the tip's depth under the top; a plunge counts where it ends.
  EXPECT_DOUBLE_EQ(bare.depth(flat, {5, 5, 20}, {5, 5, 4.5}), 0.5);
  EXPECT_EQ(bare.depth(flat, {-3, -9, 0}, {-3, 20, 0}), 0);
  // A descent that crosses the far edge at a height of 4 and goes on beside.
  EXPECT_NEAR(bare.depth(flat, {0, 5, 6.0}, {10, 5, 4.0}), 1.0, 1e-6);
  // The margin counts on both.
  const KeepOut wide({KeepOutZone::box(0, 0, 10, 10, 5)}, 1.0);
  EXPECT_DOUBLE_EQ(wide.depth(flat, {-2, 5, -50}, {-2, 6, -50}), 2.0);
  EXPECT_DOUBLE_EQ(wide.depth(flat, {5, 5, 5.25}, {5, 6, 5.25}), 0.75);
  // Where axes do not arrive at once the way may go round a corner.
  EXPECT_EQ(wide.depth(flat, {-8, 8, 0}, {2, 18, 0}), 0);
  EXPECT_GT(wide.depthIn(flat.profile(), {-8, 8, 0}, {2, 18, 0}), 1);
  EXPECT_EQ(wide.depthIn(flat.profile(), {-8, 8, 6}, {2, 18, 9}), 0);
}

TEST(KeepOut, HighestTopOfTheZonesNearABox)
{
  const KeepOut keep(
      {KeepOutZone::box(0, 0, 10, 10, 5), KeepOutZone::cylinder(30, 0, 5, 20)}, 1.0);
  EXPECT_EQ(keep.highestTop(), 21);
  EXPECT_EQ(keep.highestTop({12, 0}, {15, 5}, 3.0), 6);
  EXPECT_EQ(keep.highestTop({12, 0}, {22, 5}, 3.0), 21);
  EXPECT_EQ(keep.highestTop({15, 0}, {20, 5}, 3.0), -kInfinity);
}
