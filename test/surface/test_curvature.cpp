// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Curvatures against closed forms.
#include <pointmill/common/error.h>
#include <pointmill/surface/curvature.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace pointmill;

namespace {

constexpr double kR = 10.0;

double dome(double x, double y)
{
  return std::sqrt(kR * kR - x * x - y * y);
}
double bowl(double x, double y)
{
  return -dome(x, y);
}
double channel(double x, double)
{
  return -std::sqrt(kR * kR - x * x);
}
double slope(double x, double y)
{
  return 0.7 * x - 0.4 * y;
}
/// Curvatures 0.1 and -0.06 at the middle.
double saddle(double x, double y)
{
  return 0.05 * x * x - 0.03 * y * y;
}

/// 12 x 12 mm about the middle, and its map of 0.5 mm.
struct Ground {
  explicit Ground(double (*height)(double, double))
  {
    std::vector<float> x, y, z;
    for (int i = -120; i <= 120; ++i)
      for (int k = -120; k <= 120; ++k) {
        x.push_back(static_cast<float>(0.05 * i));
        y.push_back(static_cast<float>(0.05 * k));
        z.push_back(static_cast<float>(height(0.05 * i, 0.05 * k)));
      }
    points = std::make_unique<PointIndex>(x, y, z);
    map.resize(24 * 24);
    map.width = map.height = 24;
    for (int r = 0; r < 24; ++r)
      for (int c = 0; c < 24; ++c) {
        PointCell& cell = map.at(c, r);
        cell.x = static_cast<float>(-5.75 + 0.5 * c);
        cell.y = static_cast<float>(-5.75 + 0.5 * r);
        cell.z = static_cast<float>(height(cell.x, cell.y));
        cell.setState(CellState::Occupied);
      }
  }
  std::unique_ptr<PointIndex> points;
  CellCloud map;
};

/// Calls body(hollow, ridge, cell) for the cells within 3 mm of the middle.
template <typename Body>
void eachInner(double (*height)(double, double), const Body& body)
{
  const Ground ground(height);
  const CurvatureMap map = mapCurvature(*ground.points, ground.map, 60);
  ASSERT_EQ(map.hollow.size(), ground.map.size());
  for (std::size_t i = 0; i < map.hollow.size(); ++i)
    if (std::hypot(map.hollow[i].x, map.hollow[i].y) < 3)
      body(map.hollow[i].z, map.ridge[i].z, map.hollow[i]);
}

} // namespace

TEST(Curvature, OfASphereIsThatOfItsRadiusEverywhere)
{
  eachInner(dome, [](double hollow, double ridge, const PointCell&) {
    ASSERT_NEAR(hollow, -1 / kR, 1e-3);
    ASSERT_NEAR(ridge, -1 / kR, 1e-3);
  });
  eachInner(bowl, [](double hollow, double ridge, const PointCell&) {
    ASSERT_NEAR(hollow, 1 / kR, 1e-3);
    ASSERT_NEAR(ridge, 1 / kR, 1e-3);
  });
}

TEST(Curvature, OfACylinderIsInOneDirection)
{
  eachInner(channel, [](double hollow, double ridge, const PointCell&) {
    ASSERT_NEAR(hollow, 1 / kR, 1e-3);
    ASSERT_NEAR(ridge, 0, 1e-3);
  });
}

TEST(Curvature, OfAPlaneIsNoneHoweverItLeans)
{
  eachInner(slope, [](double hollow, double ridge, const PointCell&) {
    ASSERT_NEAR(hollow, 0, 1e-3);
    ASSERT_NEAR(ridge, 0, 1e-3);
  });
}

TEST(Curvature, OfASaddleHasBothSigns)
{
  eachInner(saddle, [](double hollow, double ridge, const PointCell& cell) {
    // Of a graph: H and K from its derivatives.
    const double p = 0.1 * cell.x, q = -0.06 * cell.y, w = 1 + p * p + q * q;
    const double mean =
        ((1 + q * q) * 0.1 + (1 + p * p) * -0.06) / (2 * std::pow(w, 1.5));
    const double gauss = 0.1 * -0.06 / (w * w), half = std::sqrt(mean * mean - gauss);
    ASSERT_NEAR(hollow, mean + half, 1e-3);
    ASSERT_NEAR(ridge, mean - half, 1e-3);
  });
}

TEST(Curvature, NoiseIsFlatAndFormIsNot)
{
  const auto mapWithNoise = [](double (*height)(double, double)) {
    const Ground ground(height);
    pointmill_test::Random random(7);
    std::vector<float> x, y, z;
    for (std::size_t i = 0; i < ground.points->size(); ++i) {
      const Eigen::Vector3d p = ground.points->point(i);
      x.push_back(static_cast<float>(p.x()));
      y.push_back(static_cast<float>(p.y()));
      z.push_back(static_cast<float>(p.z() + random.uniform(-0.01, 0.01)));
    }
    return mapCurvature(PointIndex(x, y, z), ground.map, 600);
  };
  const auto flat = mapWithNoise(slope).hollow;
  const auto told = std::count_if(
      flat.begin(), flat.end(), [](const PointCell& c) { return c.z != 0; });
  EXPECT_LT(told, static_cast<long>(flat.size() / 50));
  const auto round = mapWithNoise(bowl).hollow;
  EXPECT_NEAR(round.at(12, 12).z, 1 / kR, 0.05);
  EXPECT_GT(round.at(12, 12).z, 0);
}

TEST(Curvature, ALargeMapIsThinnedOut)
{
  const Ground ground(bowl);
  const CurvatureMap map = mapCurvature(*ground.points, ground.map, 60, 150);
  EXPECT_EQ(map.hollow.width, 12u);
  EXPECT_EQ(map.hollow.height, 12u);
  EXPECT_FLOAT_EQ(map.hollow[0].x, -5.5f); // the middle of the first two
  EXPECT_FLOAT_EQ(map.hollow[1].x, -4.5f);
  EXPECT_NEAR(map.hollow.at(6, 6).z, 1 / kR, 1e-3);
}

TEST(Curvature, WhereThereIsNoPartThereIsNone)
{
  Ground ground(bowl);
  ground.map[0].setState(CellState::Empty);
  EXPECT_TRUE(std::isnan(mapCurvature(*ground.points, ground.map).hollow[0].z));
  EXPECT_THROW(mapCurvature(*ground.points, CellCloud()), DataError);
  EXPECT_THROW(mapCurvature(*ground.points, ground.map, 5), ParameterError);
}
