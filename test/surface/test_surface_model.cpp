// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Cutters on the smooth surface between the points, against closed forms.
#include <pointmill/common/error.h>
#include <pointmill/surface/surface_model.h>
#include <pointmill_test/clouds.h>
#include <pointmill_test/freeform.h>

#include <gtest/gtest.h>

using namespace pointmill_test;
using Eigen::Vector2d;
using Eigen::Vector3d;
using pointmill::Contact;
using pointmill::SmoothSurface;
using pointmill::SurfaceModel;
using pointmill::Tool;

namespace {

const std::vector<Tool> kTools{
    Tool::flat(1, 4.0), Tool::ball(2, 3.0), Tool::bull(3, 5.0, 1.0)};

SurfaceModel smooth(const Cloud& cloud, double fidelity = 0.005)
{
  return SurfaceModel(indexOf(cloud), SmoothSurface{24, fidelity});
}

struct Errors {
  double rms = 0, mean = 0, p99 = 0;
};

Errors errorsOnFreeform(const SurfaceModel& model, double edge, double radius)
{
  const Tool ball = Tool::ball(1, 2 * radius);
  std::vector<double> errors;
  Errors e;
  for (double y = 3; y <= edge - 3; y += 0.7) {
    std::vector<Contact> row(static_cast<std::size_t>((edge - 6) / 0.3));
    model.dropRow(ball, {3, y}, {0.3, 0}, row.size(), row.data());
    for (std::size_t i = 0; i < row.size(); ++i)
      errors.push_back(row[i].tip - Freeform::tip(radius, 3 + 0.3 * double(i), y));
  }
  for (auto& error : errors) {
    e.mean += error / double(errors.size());
    e.rms += error * error / double(errors.size());
    error = std::abs(error);
  }
  e.rms = std::sqrt(e.rms);
  std::sort(errors.begin(), errors.end());
  e.p99 = errors[errors.size() * 99 / 100];
  return e;
}

} // namespace

TEST(SurfaceModel, OfBarePointsIsTheirIndex)
{
  const auto cloud = Freeform::sample(5000, 20, 0, 1);
  const SurfaceModel model(indexOf(*cloud));
  EXPECT_FALSE(model.isSmooth());
  for (const auto& tool : kTools) {
    const Contact c = model.drop(tool, 7, 9), i = model.points().drop(tool, 7, 9);
    EXPECT_EQ(c.tip, i.tip);
    EXPECT_EQ(c.at, i.at);
  }
}

TEST(SurfaceModel, OnASlopeEveryCutterRestsOnThePlaneBetweenThePoints)
{
  const Vector3d n = Vector3d(0.3, -0.5, 1).normalized();
  const auto height = [&](double x, double y) {
    return -(n.x() * x + n.y() * y) / n.z();
  };
  // 1 mm apart: a bare flat end mill would sink by up to half a millimetre.
  const auto cloud = surface({0, 0, 30, 30}, 1.0, height);
  const SurfaceModel model = smooth(*cloud);
  for (const auto& tool : kTools) {
    const double flat = tool.radius() - tool.corner_radius;
    // The rim of the flat stands `flat * slope` above the axis, the rounding lies
    // `corner (1 / n_z - 1)` lower than it would on a level.
    const double lift =
        flat * n.head<2>().norm() / n.z() + tool.corner_radius * (1 / n.z() - 1);
    double bare = 0;
    for (double y = 8; y < 22; y += 0.77)
      for (double x = 8; x < 22; x += 0.83) {
        const Contact c = model.drop(tool, x, y);
        EXPECT_NEAR(c.tip, height(x, y) + lift, 5e-6) << tool.describe();
        bare =
            std::max(bare, height(x, y) + lift - model.points().drop(tool, x, y).tip);
        // the contact lies on the plane, and its normal is the plane's
        EXPECT_NEAR(c.at.z(), height(c.at.x(), c.at.y()), 5e-6);
        if (!tool.isFlat()) {
          const Vector3d m = contactNormal(tool, x, y, c);
          EXPECT_LT((m - n).norm(), 1e-4) << tool.describe();
        }
      }
    EXPECT_GT(bare, 0.05) << tool.describe();
  }
}

TEST(SurfaceModel, OnASphereTheBallRestsOnTheOffsetSphere)
{
  // Convex from above and concave from above, R = 20, 0.4 mm between points.
  const Tool ball = Tool::ball(1, 4);
  for (const double sign : {1.0, -1.0}) {
    const auto cloud = surface({-12, -12, 12, 12}, 0.4, [&](double x, double y) {
      return sign * std::sqrt(400 - x * x - y * y);
    });
    const SurfaceModel model = smooth(*cloud);
    double worst = 0, bare = 0;
    for (double y = -8; y < 8; y += 0.57)
      for (double x = -8; x < 8; x += 0.61) {
        const double d2 = x * x + y * y;
        const double tip = sign * std::sqrt(std::pow(20 + sign * 2, 2) - d2) - 2;
        const double error = model.drop(ball, x, y).tip - tip;
        worst = std::max(worst, std::abs(error));
        bare = std::max(bare, std::abs(model.points().drop(ball, x, y).tip - tip));
      }
    EXPECT_LT(worst, 5e-4) << sign;
    EXPECT_GT(bare, 0.01) << sign;
  }
}

TEST(SurfaceModel, TakesThePointsSpacingOutOfTheError)
{
  // 10 points/mm2: a ball of 1.5 mm sinks 10.6 um on the average between bare points.
  const auto cloud = Freeform::sample(16000, 40, 0, 5);
  const SurfaceModel bare(indexOf(*cloud));
  const Errors before = errorsOnFreeform(bare, 40, 1.5);
  const Errors after = errorsOnFreeform(smooth(*cloud), 40, 1.5);
  EXPECT_LT(before.mean, -0.008);
  EXPECT_LT(after.rms, 0.001);
  EXPECT_LT(after.p99, 0.002);
  EXPECT_LT(std::abs(after.mean), 0.0002);
}

TEST(SurfaceModel, IsNeverLowerThanTheBarePoints)
{
  const auto cloud = Freeform::sample(4000, 20, 0.05, 9);
  const SurfaceModel model = smooth(*cloud, 0.1);
  for (const auto& tool : kTools)
    for (double y = -1; y < 21; y += 0.9)
      for (double x = -1; x < 21; x += 0.9)
        EXPECT_GE(model.drop(tool, x, y).tip, model.points().drop(tool, x, y).tip);
}

TEST(SurfaceModel, NeitherRoundsAStepNorReachesBeyondIt)
{
  // A step 4 mm high at x = 10; its face has no points, or has them.
  for (const bool face : {false, true}) {
    auto cloud = surface(
        {0, 0, 20, 12}, 0.25, [](double x, double) { return x <= 10 ? 4.0 : 0.0; });
    if (face)
      for (int k = 1; k < 16; ++k)
        addSurface(
            *cloud, {10, 0, 10, 12}, 0.25, [&](double, double) { return 0.25 * k; });
    const SurfaceModel model = smooth(*cloud);
    for (const auto& tool : kTools)
      for (double x = 6; x < 16; x += 0.07) {
        const double y = 6.1, tip = model.drop(tool, x, y).tip;
        // Of a plateau that ends at the edge, and a floor.
        const double over = x - 10;
        const double truth = over <= 0               ? 4.0
                             : over <= tool.radius() ? 4.0 - tool.profile(over)
                                                     : 0.0;
        const double bare = model.points().drop(tool, x, y).tip;
        EXPECT_GE(tip, bare);
        // Beside the edge's own points it may be that of the bare points.
        EXPECT_LE(tip, std::max(truth, bare) + 1e-6) << tool.describe() << " " << x;
      }
  }
}

TEST(SurfaceModel, LaysNoPatchOverTheBorderOfThePart)
{
  const auto cloud =
      surface({0, 0, 10, 10}, 0.3, [](double x, double) { return 0.8 * x; });
  const SurfaceModel model = smooth(*cloud);
  const Tool ball = Tool::ball(1, 3);
  // The highest points are at x = 10: beyond it the ball rolls round that edge.
  for (double x = 10.5; x < 11.5; x += 0.1) {
    const double ideal = 8 - 1.5 + std::sqrt(2.25 - (x - 10) * (x - 10));
    EXPECT_LE(model.drop(ball, x, 5.1).tip, ideal + 1e-6) << x;
  }
}

TEST(SurfaceModel, AnswersTheSameInARowAsAlone)
{
  const auto cloud = Freeform::sample(6000, 20, 0.01, 4);
  const SurfaceModel model = smooth(*cloud, 0.03);
  const Vector2d from(1, 2), step(0.13, 0.11);
  for (const auto& tool : kTools) {
    std::vector<Contact> row(120);
    model.dropRow(tool, from, step, row.size(), row.data());
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Vector2d at = from + double(i) * step;
      const Contact one = model.drop(tool, at.x(), at.y());
      EXPECT_EQ(row[i].tip, one.tip);
      EXPECT_EQ(row[i].at, one.at);
    }
  }
}

TEST(SurfaceModel, RefusesAbsurdSettings)
{
  const auto index = indexOf(*Freeform::sample(100, 10, 0, 4));
  EXPECT_THROW(SurfaceModel(index, SmoothSurface{5, 0.01}), pointmill::ParameterError);
  EXPECT_THROW(SurfaceModel(index, SmoothSurface{24, 0.0}), pointmill::ParameterError);
}
