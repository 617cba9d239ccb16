// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/spacing.h>
#include <pointmill/slice/spacing_map.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pointmill;
using pointmill_test::Random;
using Points = std::vector<Eigen::Vector3f>;

namespace {

/// A square grid, without the points for which `missing` holds.
template <typename Missing>
Points squareGrid(int along, double edge, Missing&& missing)
{
  Points points;
  for (int row = 0; row < along; ++row)
    for (int column = 0; column < along; ++column)
      if (!missing(column, row))
        points.emplace_back(float(column * edge), float(row * edge), 0.f);
  return points;
}

Points squareGrid(int along, double edge)
{
  return squareGrid(along, edge, [](int, int) { return false; });
}

Points randomPoints(double edge, double density, std::uint64_t seed)
{
  Random random(seed);
  Points points;
  for (int i = 0; i < int(edge * edge * density); ++i)
    points.emplace_back(
        float(random.uniform(0, edge)), float(random.uniform(0, edge)), 0.f);
  return points;
}

pcl::PointCloud<pcl::PointXYZ> cloudOf(const Points& points)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const auto& p : points)
    cloud.push_back({p.x(), p.y(), p.z()});
  return cloud;
}

double voidAt(const Points& points, double x, double y)
{
  double least = INFINITY;
  for (const auto& p : points)
    least = std::min(least, std::hypot(p.x() - x, p.y() - y));
  return least;
}

/// The largest void at a raster of places in a square.
double largestVoid(const Points& points, double x0, double y0, double edge, double step)
{
  double most = 0;
  for (double y = y0 + step / 2; y < y0 + edge; y += step)
    for (double x = x0 + step / 2; x < x0 + edge; x += step)
      most = std::max(most, voidAt(points, x, y));
  return most;
}

} // namespace

TEST(Spacing, OfASquareGridIsItsEdge)
{
  for (const double edge : {0.03, 0.4, 7.0}) {
    const SpacingField field = mapSpacing(squareGrid(100, edge));
    EXPECT_NEAR(field.figures.median, edge, 0.01 * edge);
    EXPECT_NEAR(field.figures.p99, edge, 0.01 * edge);
    EXPECT_NEAR(field.figures.worst, edge, 1e-4 * edge);
    for (const float s : field.spacing)
      if (!std::isnan(s)) {
        EXPECT_NEAR(s, edge, 1e-4 * edge);
      }
  }
}

TEST(Spacing, OfRandomPointsIsThatOfTheirDensity)
{
  // A disc of area a holds none of them with probability exp(-rho a).
  const double rho = 4;
  const Spacing spacing = mapSpacing(randomPoints(200, rho, 3)).figures;
  EXPECT_NEAR(spacing.median, std::sqrt(std::log(2) / (M_PI * rho)) / 0.39894, 0.005);
  EXPECT_NEAR(spacing.p99, std::sqrt(std::log(100) / (M_PI * rho)) / 0.65776, 0.02);
  EXPECT_GT(spacing.worst, spacing.p99);
}

TEST(Spacing, OfLinesIsThatBetweenThem)
{
  for (const double apart : {1.0, 5.0}) {
    Points points;
    for (int line = 0; line < 40; ++line)
      for (int i = 0; i < 1000; ++i)
        points.emplace_back(0.05f * float(i), float(line * apart), 0.f);
    const Spacing spacing = mapSpacing(points).figures;
    EXPECT_NEAR(spacing.median, apart / 4 / 0.39894, 0.02 * apart);
    EXPECT_NEAR(spacing.worst, apart / std::sqrt(2.0), 0.005 * apart);
    EXPECT_LE(spacing.p99, spacing.worst);
  }
}

TEST(Spacing, TheWorstPlaceIsFoundWhereOnePointIsMissing)
{
  const Points points =
      squareGrid(200, 0.4, [](int c, int r) { return c == 50 && r == 70; });
  const SpacingField field = mapSpacing(points);
  const Spacing& s = field.figures;
  EXPECT_NEAR(s.worst, 0.4 * std::sqrt(2.0), 1e-4); // a void of radius 0.4
  EXPECT_NEAR((s.worst_at - Eigen::Vector2d(20, 28)).norm(), 0, 1e-4);
  EXPECT_NEAR(s.p99, 0.4, 0.004);
  const CellGrid& grid = field.grid;
  EXPECT_NEAR(
      field.spacing[grid.index(grid.columnOf(20), grid.rowOf(28))], s.worst, 1e-6);
}

TEST(Spacing, OfEachCellIsThatOfItsLargestVoid)
{
  const Points points = randomPoints(16, 2, 11);
  for (const double cell : {1.0, 4.0}) {
    const SpacingField field = mapSpacing(points, cell, 3.0);
    int judged = 0;
    for (int row = 0; row < field.grid.rows; ++row)
      for (int column = 0; column < field.grid.columns; ++column) {
        const double x0 = field.grid.x0 + column * cell,
                     y0 = field.grid.y0 + row * cell;
        if (x0 < 3 || y0 < 3 || x0 + cell > 13 || y0 + cell > 13)
          continue; // near the outline
        const double radius =
            field.spacing[field.grid.index(column, row)] / std::sqrt(2.0);
        // At least the largest in it, and one that reaches it.
        EXPECT_GE(radius, 0.97 * largestVoid(points, x0, y0, cell, 0.1));
        EXPECT_LE(radius,
                  1e-5 + 0.1 + largestVoid(points, x0 - 2, y0 - 2, cell + 4, 0.1));
        ++judged;
      }
    EXPECT_GT(judged, cell > 1 ? 3 : 60);
  }
}

TEST(Spacing, GapsAndWhatLiesOutsideDoNotCount)
{
  // A disc with a hole in it, and the empty corners of its box.
  Points points = squareGrid(300, 0.1, [](int c, int r) {
    const double d = std::hypot(c - 150, r - 150);
    return d > 140 || d < 40;
  });
  const SpacingField field = mapSpacing(points);
  EXPECT_NEAR(field.figures.worst, 0.1, 0.001);
  const CellGrid& grid = field.grid;
  EXPECT_TRUE(std::isnan(field.spacing[grid.index(grid.columnOf(15), grid.rowOf(15))]));
  EXPECT_TRUE(std::isnan(field.spacing[grid.index(0, 0)]));
  EXPECT_NEAR(field.spacing[grid.index(grid.columnOf(22), grid.rowOf(22))], 0.1, 1e-3);

  // With a reach wider than the hole it is a void between points.
  EXPECT_NEAR(mapSpacing(points, 0, 6).figures.worst, std::sqrt(2.0) * 4, 0.1);
}

TEST(Spacing, CountsThePointsOfEachCell)
{
  const Points points = randomPoints(20, 5, 5);
  const SpacingField field = mapSpacing(points, 1.5);
  std::vector<std::uint32_t> truth(field.grid.size(), 0);
  for (const auto& p : points)
    ++truth[field.grid.index(field.grid.columnOf(p.x()), field.grid.rowOf(p.y()))];
  EXPECT_EQ(field.count, truth);
}

TEST(Spacing, OfPointsThatCoverNothingIsRefused)
{
  EXPECT_THROW(measureSpacing({}), DataError);
  EXPECT_THROW(mapSpacing({{1, 2, 3}}), DataError);
  Points line;
  for (int i = 0; i < 100; ++i)
    line.emplace_back(float(i), 0.5f * float(i), 0.f);
  EXPECT_THROW(mapSpacing(line), DataError);
  EXPECT_THROW(mapSpacing(squareGrid(10, 1), -1), ParameterError);
  EXPECT_THROW(mapSpacing(squareGrid(10, 1), 0, -1), ParameterError);
  EXPECT_THROW(mapSpacing(squareGrid(10, 1), 0, NAN), ParameterError);
}

TEST(Spacing, LeavesOutWhatIsNotFinite)
{
  auto cloud = cloudOf(squareGrid(50, 1));
  cloud.push_back({NAN, 1, 2});
  cloud.push_back({1, 1, INFINITY});
  EXPECT_NEAR(measureSpacing(cloud).worst, 1, 1e-4);
}

TEST(SpacingMap, ShowsTheFieldOnTheCellsOfAnOccupancyMap)
{
  const Points points = randomPoints(20, 9, 8);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(
      new pcl::PointCloud<pcl::PointXYZ>(cloudOf(points)));
  cloud->push_back({NAN, 0, 0});
  SpacingMap<pcl::PointXYZ> map;
  map.setCellSize(2);
  map.setGapReach(1.5);
  map.setInputCloud(cloud);
  CellCloud cells;
  map.filter(cells);
  const SpacingField field = mapSpacing(points, 2, 1.5);
  const CellGrid grid = CellGrid::of(cells);
  EXPECT_NEAR(grid.cell, 2, 1e-6);
  EXPECT_EQ(int(cells.width), field.grid.columns);
  EXPECT_EQ(int(cells.height), field.grid.rows);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool covered = !std::isnan(field.spacing[i]);
    EXPECT_EQ(cells[i].getState(), covered ? CellState::Occupied : CellState::Empty);
    EXPECT_EQ(cells[i].count, field.count[i]);
    if (covered) {
      EXPECT_EQ(cells[i].z, field.spacing[i]);
    }
  }
  EXPECT_EQ(map.getSpacing().worst, field.figures.worst);
  EXPECT_EQ(map.getReport().get("nan_points"), 1);
  EXPECT_EQ(map.getReport().get("worst_mm"), field.figures.worst);
  map.setCellSize(-1);
  EXPECT_THROW(map.filter(cells), ParameterError);
}
