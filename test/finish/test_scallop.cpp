// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Scallops, measured along the normal of surfaces in closed form.
#include "finish_test.h"

#include <functional>
#include <map>
#include <set>

using namespace finish_test;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 1.5, kLimit = 0.01, kMargin = 1.6;

struct Ground {
  const char* name;
  Rectangle area;
  double step;
  std::function<double(double, double)> z;
  std::function<Vector3d(double, double)> normal;
};

Ground slope(double degrees, double azimuth)
{
  const double rise = std::tan(degrees * M_PI / 180);
  const double a = rise * std::cos(azimuth * M_PI / 180);
  const double b = rise * std::sin(azimuth * M_PI / 180);
  return {"slope",
          {0, 0, 7, 7},
          0.07 * std::cos(degrees * M_PI / 180),
          [=](double x, double y) { return a * x + b * y; },
          [=](double, double) -> Vector3d { return Vector3d(-a, -b, 1).normalized(); }};
}

/// The upper half of a sphere about the origin, or the lower one seen from above; with
/// `across` 0 or `along` 0 a cylinder.
Ground
rounded(const char* name, double radius, double along, double across, double half)
{
  const double r = std::abs(radius), sign = radius > 0 ? 1 : -1;
  const auto height = [=](double x, double y) {
    return sign * std::sqrt(r * r - along * x * x - across * y * y);
  };
  return {name,
          {-half, -half, half, half},
          0.035,
          height,
          [=](double x, double y) -> Vector3d {
            return Vector3d(sign * along * x, sign * across * y, sign * height(x, y)) /
                   r;
          }};
}

CLSurface<pcl::PointXYZ> stageFor(double degrees = 0)
{
  CLSurface<pcl::PointXYZ> stage;
  stage.setTool(Tool::ball(1, 2 * kRadius));
  stage.setScallop(kLimit);
  stage.setForwardStep(0.125);
  stage.setAngle(degrees);
  stage.setFloor(-1000);
  return stage;
}

std::vector<Eigen::Vector2d> square(const Rectangle& r)
{
  return {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
}

/// The most that the balls of the path leave above random places of the ground, away
/// from its border: the way out along the normal to the nearest of their surfaces.
double highestLeft(const CLCloud& path, const Ground& ground)
{
  struct Move {
    Vector3d a, b;
  };
  std::vector<Move> moves;
  const Vector3d up(0, 0, kRadius);
  forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
    moves.push_back({a + up, b + up});
  });
  const auto distance = [](const Move& m, const Vector3d& p) {
    const Vector3d d = m.b - m.a;
    const double t = d.squaredNorm() > 0 ? (p - m.a).dot(d) / d.squaredNorm() : 0;
    return (m.a + std::clamp(t, 0.0, 1.0) * d - p).norm();
  };
  Random random(5);
  const Rectangle inner = ground.area.inner(kMargin + 0.4);
  double highest = 0;
  for (int i = 0; i < 6000; ++i) {
    const double x = random.uniform(ground.area.x0, ground.area.x1);
    const double y = random.uniform(ground.area.y0, ground.area.y1);
    const Vector3d q(x, y, ground.z(x, y)), n = ground.normal(x, y);
    const Vector3d axis = q + kRadius * n;
    if (!inner.holds(axis.x(), axis.y()))
      continue; // cut from outside the boundary
    std::vector<Move> near;
    for (const auto& m : moves)
      if (distance(m, q) < kRadius + 0.2)
        near.push_back(m);
    const auto inside = [&](double t) {
      for (const auto& m : near)
        if (distance(m, q + t * n) < kRadius)
          return true;
      return false;
    };
    double low = -0.05, high = 0.2;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (low + high);
      (inside(middle) ? high : low) = middle;
    }
    highest = std::max(highest, high);
  }
  return highest;
}

struct Outcome {
  double highest, predicted_max, predicted_p95, inserted;
};

Outcome mill(const Ground& ground, CLSurface<pcl::PointXYZ> stage)
{
  const auto cloud = surface(ground.area, ground.step, ground.z);
  stage.setBoundary(square(ground.area.inner(kMargin)));
  const auto path = raster(stage, cloud);
  const auto& report = stage.getReport();
  return {highestLeft(path, ground),
          report.get("scallop_max_mm"),
          report.get("scallop_p95_mm"),
          report.get("inserted_passes")};
}

} // namespace

TEST(Scallop, OfAFlatIsTheLimitAndNoRowIsInserted)
{
  const auto flat = mill(slope(0, 0), stageFor());
  EXPECT_LE(flat.highest, 1.05 * kLimit);
  EXPECT_GE(flat.highest, 0.9 * kLimit);
  EXPECT_NEAR(flat.predicted_max, flat.highest, 0.05 * kLimit);
}

TEST(Scallop, HoldsOnSlopesOfAnyAzimuth)
{
  for (const double degrees : {30, 60, 80})
    for (const double azimuth : {0, 35, 70, 90, 160}) {
      const auto outcome =
          mill(slope(degrees, azimuth), stageFor(azimuth > 100 ? 25 : 0));
      EXPECT_LE(outcome.highest, 1.06 * kLimit) << degrees << " " << azimuth;
      // Halving spacings may make them half of what they could be.
      EXPECT_GE(outcome.highest, 0.22 * kLimit) << degrees << " " << azimuth;
    }
}

TEST(Scallop, HoldsOnSpheresAndCylinders)
{
  for (const auto& ground : {rounded("ball", 10, 1, 1, 6),
                             rounded("bowl", -8, 1, 1, 5),
                             rounded("tight bowl", -3.5, 1, 1, 2.2),
                             rounded("ridge along", 5, 0, 1, 4.5),
                             rounded("ridge across", 5, 1, 0, 4.5),
                             rounded("valley along", -4, 0, 1, 3.4),
                             rounded("valley across", -4, 1, 0, 3.4)}) {
    const auto outcome = mill(ground, stageFor());
    EXPECT_LE(outcome.highest, 1.08 * kLimit) << ground.name;
    EXPECT_GE(outcome.highest, 0.3 * kLimit) << ground.name;
    EXPECT_NEAR(outcome.predicted_max, outcome.highest, 0.2 * kLimit) << ground.name;
    EXPECT_LE(outcome.predicted_p95, outcome.predicted_max) << ground.name;
  }
}

TEST(Scallop, IsExceededWhereNoRowsAreInserted)
{
  auto stage = stageFor();
  stage.setMinStepOver(10);
  const auto outcome = mill(slope(60, 90), stage);
  EXPECT_EQ(outcome.inserted, 0);
  EXPECT_NEAR(outcome.highest, 4 * kLimit, 0.3 * kLimit)
      << "rows are twice as far apart";
  EXPECT_NEAR(outcome.predicted_max, outcome.highest, 0.05 * kLimit);
}

TEST(Scallop, OfACliffIsHeldByRowsAcrossIt)
{
  // A step 6 high with a wall of points, which the rows run along.
  Ground wall{"wall",
              {0, -8, 8, 8},
              0.05,
              [](double, double y) { return y > 0 ? 6 : 0; },
              [](double, double) { return Vector3d(0, -1, 0); }};
  const auto cloud = surface(wall.area, wall.step, wall.z);
  for (double z = 0.05; z < 6; z += 0.05)
    for (double x = 0; x <= 8; x += 0.05)
      cloud->push_back(pcl::PointXYZ(float(x), 0.025f, float(z)));
  auto stage = stageFor();
  for (const bool across : {false, true}) {
    stage.setAcross(across);
    BufferPoints<pcl::PointXYZ> buffer;
    buffer.setSurface(cloud);
    buffer.setTool(stage.getTool());
    buffer.setTolerance(0.1 * kLimit);
    buffer.setShortestChord(0.002);
    stage.setInputCloud(cloud);
    const CLCloud path = *run<pcl::PointXYZ>(cloud, stage, buffer);
    const auto& report = stage.getReport();
    EXPECT_EQ(report.get("across_passes") > 10, across);
    // But for the block's corners, where balls hang beside its ends.
    const double exceeded = report.get("scallop_exceeded_mm2");
    if (across)
      EXPECT_LT(exceeded, 0.2);
    else
      EXPECT_GT(exceeded, 2);
    // On the wall's middle: how far does the nearest ball stay away?
    std::vector<Vector3d> centres;
    forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
      for (double t = 0; t < 1; t += 0.02 / std::max(0.02, (b - a).norm()))
        centres.push_back(a + t * (b - a) + Vector3d(0, 0, kRadius));
    });
    double worst = 0;
    for (double z = 2.5; z < 3.5; z += 0.1)
      for (double x = 3.6; x < 4.4; x += 0.02) {
        double nearest = 1e9;
        for (const auto& c : centres)
          nearest = std::min(nearest, (c - Vector3d(x, 0.025, z)).norm() - kRadius);
        worst = std::max(worst, nearest);
      }
    if (across)
      EXPECT_LE(worst, 1.2 * kLimit);
    else
      EXPECT_GE(worst, 5 * kLimit);
  }
}

TEST(Scallop, InsertedRowsStayOnTheSlopeThatNeedsThem)
{
  // Flat, 65 degrees, flat; rows along the contour.
  const double rise = std::tan(65 * M_PI / 180);
  const auto cloud = surface({0, 0, 12, 24}, 0.06, [&](double, double y) {
    return rise * std::clamp(y - 10, 0.0, 4.0);
  });
  auto stage = stageFor();
  const auto path = raster(stage, cloud);
  EXPECT_GT(stage.getReport().get("inserted_passes"), 12);
  EXPECT_EQ(stage.getReport().get("across_passes"), 0);
  std::set<float> rows;
  for (const auto& p : path)
    if (p.x > 3 && p.x < 9)
      rows.insert(p.y);
  std::size_t flat = 0, slope = 0;
  for (const float y : rows) {
    flat += y > 2 && y < 8;
    slope += y > 10 && y < 12;
  }
  EXPECT_NEAR(flat, 6 / stage.getStepOver(), 1.5);
  // cos 65 asks for 2.4 times as many, halving gives 4 times.
  EXPECT_NEAR(slope, 4 * 2 / stage.getStepOver(), 3);
}

TEST(Scallop, PassesAreNoCrumbs)
{
  // A hill whose flanks need more rows than its top and foot.
  const auto cloud = surface({-12, -12, 12, 12}, 0.08, [](double x, double y) {
    return 9 * std::exp(-(x * x + y * y) / 30);
  });
  auto stage = stageFor();
  stage.setForwardStep(0.5);
  const auto path = raster(stage, cloud);
  std::map<std::uint32_t, Rectangle> boxes;
  for (const auto& p : path) {
    Rectangle& box =
        boxes.emplace(p.label, Rectangle{p.x, p.y, p.x, p.y}).first->second;
    box.x0 = std::min<double>(box.x0, p.x);
    box.x1 = std::max<double>(box.x1, p.x);
  }
  int inside = 0;
  for (const auto& [label, box] : boxes) {
    if (std::abs(box.y0) > 11 || box.x0 < -11 || box.x1 > 11)
      continue; // cut short by the ground's border
    ++inside;
    EXPECT_GT(box.x1 - box.x0, 0.9) << label;
  }
  EXPECT_GT(inside, 20);
}

TEST(Scallop, OfARoughScanDoesNotBreedRows)
{
  // 50 um of noise on a flat: what looks like curvature is none.
  Random random(9);
  const auto cloud = surface(
      {0, 0, 20, 20}, 0.2, [&](double, double) { return 0.05 * random.normal(); });
  auto stage = stageFor();
  stage.setForwardStep(0.5);
  stage.setBoundary(square({1, 1, 19, 19}));
  const auto path = raster(stage, cloud);
  stage.setMinStepOver(100); // none are inserted
  EXPECT_LT(path.size(), 1.2 * raster(stage, cloud).size());
}

TEST(Scallop, RowsAreTheSameForAnyNumberOfThreads)
{
  const auto cloud = sample(shapes()[1], 0.5, 2);
  auto stage = stageFor();
  stage.setAcross(true);
  stage.setFloor(0);
  stage.setNumberOfThreads(1);
  const std::string one = bytes(raster(stage, cloud));
  for (const unsigned threads : {2u, 5u}) {
    stage.setNumberOfThreads(threads);
    EXPECT_EQ(bytes(raster(stage, cloud)), one) << threads;
  }
}
