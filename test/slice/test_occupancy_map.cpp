// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/occupancy_map.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pointmill;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

/// A 40 x 30 mm plate at z = 2, 4 points per mm2, with a 10 x 10 mm hole in the middle.
Cloud::Ptr plateWithHole()
{
  Cloud::Ptr cloud(new Cloud);
  for (double y = 0; y <= 30; y += 0.5)
    for (double x = 0; x <= 40; x += 0.5)
      if (!(x > 15 && x < 25 && y > 10 && y < 20))
        cloud->push_back(pcl::PointXYZ(float(x), float(y), 2.f));
  return cloud;
}

OccupancyMap<pcl::PointXYZ> mapOf(const Cloud::Ptr& cloud, double cell = 1.0)
{
  OccupancyMap<pcl::PointXYZ> map;
  map.setCellSize(cell);
  map.setGapReach(1.5);
  map.setInputCloud(cloud);
  return map;
}

} // namespace

TEST(OccupancyMap, HoldsTheHighestPointOfEveryCell)
{
  Cloud::Ptr cloud(new Cloud);
  std::mt19937 random(9);
  for (int i = 0; i < 5000; ++i)
    cloud->push_back(pcl::PointXYZ(float(random() % 10000) / 500.f,
                                   float(random() % 10000) / 700.f,
                                   float(random() % 10000) / 1000.f));
  auto map = mapOf(cloud, 0.7);
  CellCloud cells;
  map.filter(cells);
  EXPECT_NEAR(CellGrid::of(cells).cell, 0.7, 1e-6);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const auto& p : *cloud) {
    low = low.cwiseMin(Eigen::Vector2d(p.x, p.y));
    high = high.cwiseMax(Eigen::Vector2d(p.x, p.y));
  }
  EXPECT_NEAR(CellGrid::of(cells).x0, low.x(), 1e-5); // Gridstart
  EXPECT_NEAR(CellGrid::of(cells).y0, low.y(), 1e-5);
  const CellGrid grid = CellGrid::covering(low, high, 0.7);
  std::vector<float> truth(cells.size(), -1);
  std::vector<unsigned> count(cells.size(), 0);
  for (const auto& p : *cloud) {
    const auto at = grid.index(grid.columnOf(p.x), grid.rowOf(p.y));
    truth[at] = std::max(truth[at], p.z);
    ++count[at];
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cells[i].count, count[i]);
    if (count[i]) {
      EXPECT_EQ(cells[i].getState(), CellState::Occupied);
      EXPECT_EQ(cells[i].z, truth[i]);
    }
  }
}

TEST(OccupancyMap, AHoleInTheScanIsAProtectedGap)
{
  auto map = mapOf(plateWithHole());
  CellCloud cells;
  map.filter(cells);
  EXPECT_EQ(cells.at(20, 15).getState(), CellState::Gap);
  EXPECT_NEAR(cells.at(20, 15).z, 2.0, 1e-6);
  ASSERT_EQ(map.getGaps().size(), 1u);
  EXPECT_NEAR(map.getGaps()[0].area, 9 * 9, 20);
  EXPECT_NEAR(map.getReport().get("gap_area_mm2"), 9 * 9, 20);

  map.setGapPolicy(GapPolicy::Mill);
  map.filter(cells);
  EXPECT_EQ(cells.at(20, 15).getState(), CellState::Empty);
  EXPECT_TRUE(std::isnan(cells.at(20, 15).z));
}

TEST(OccupancyMap, KeptGapsStandAsHighAsThePart)
{
  auto cloud = plateWithHole();
  cloud->push_back(pcl::PointXYZ(1, 1, 9)); // the highest place of the part
  auto map = mapOf(cloud);
  map.setGapPolicy(GapPolicy::Keep);
  CellCloud cells;
  map.filter(cells);
  EXPECT_EQ(cells.at(20, 15).z, 9.f);
}

TEST(OccupancyMap, ANamedHoleIsMilledAndTheOtherGapsAreBridged)
{
  Cloud::Ptr cloud(new Cloud);
  for (double y = 0; y <= 30; y += 0.5)
    for (double x = 0; x <= 60; x += 0.5)
      if (std::hypot(x - 15, y - 15) > 5 && std::hypot(x - 40, y - 15) > 7)
        cloud->push_back(pcl::PointXYZ(float(x), float(y), 2.1f + 0.1f * float(x)));
  auto map = mapOf(cloud);
  map.setThroughHoles({{14, 16}});
  CellCloud cells;
  map.filter(cells);
  EXPECT_EQ(cells.at(15, 15).getState(), CellState::Empty);
  EXPECT_TRUE(std::isnan(cells.at(15, 15).z));
  EXPECT_EQ(cells.at(40, 15).getState(), CellState::Gap);
  ASSERT_EQ(map.getGaps().size(), 2u);
  const GapRegion &gap = map.getGaps()[0], &hole = map.getGaps()[1];
  EXPECT_EQ(gap.kind, GapKind::NotScanned);
  EXPECT_EQ(gap.treatment, GapPolicy::Bridge);
  EXPECT_EQ(hole.kind, GapKind::ThroughHole);
  EXPECT_EQ(hole.treatment, GapPolicy::Mill);
  EXPECT_NEAR(hole.area, M_PI * 25, 20);
  EXPECT_NEAR(hole.rim_low, 3.1, 0.15);
  EXPECT_NEAR(hole.rim_high, 4.1, 0.15);
  EXPECT_FALSE(hole.open);
  EXPECT_EQ(map.getReport().get("gaps"), 1);
  EXPECT_EQ(map.getReport().get("gap_area_mm2"), gap.area);
  EXPECT_EQ(map.getReport().get("through_holes"), 1);
  EXPECT_EQ(map.getReport().get("through_hole_area_mm2"), hole.area);
  for (const auto at : gap.cells) {
    EXPECT_GE(cells[at].z, float(gap.rim_low));
    EXPECT_LE(cells[at].z, float(gap.rim_high));
  }

  const auto before = cells;
  map.setThroughHoles({{27, 15}}); // between the two
  EXPECT_THROW(map.filter(cells), ParameterError);
  EXPECT_EQ(cells.size(), before.size());
  EXPECT_EQ(map.getGaps().size(), 2u);
}

TEST(OccupancyMap, ReadsOnlyItsIndices)
{
  auto cloud = plateWithHole();
  pcl::IndicesPtr left(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 10)
      left->push_back(int(i));
  auto map = mapOf(cloud);
  map.setIndices(left);
  CellCloud cells;
  map.filter(cells);
  EXPECT_EQ(cells.width, 10u);
  EXPECT_TRUE(map.getGaps().empty());
}

TEST(OccupancyMap, NaNPointsAreCountedAndAloneRefused)
{
  auto cloud = plateWithHole();
  cloud->push_back(pcl::PointXYZ(NAN, 0, 0));
  cloud->push_back(pcl::PointXYZ(1, 1, INFINITY));
  auto map = mapOf(cloud);
  CellCloud cells;
  map.filter(cells);
  EXPECT_EQ(map.getReport().get("nan_points"), 2);

  Cloud::Ptr none(new Cloud(3, 1, pcl::PointXYZ(NAN, NAN, NAN)));
  map.setInputCloud(none);
  EXPECT_THROW(map.filter(cells), DataError);
  EXPECT_EQ(cells.width, 41u); // untouched
}

TEST(OccupancyMap, ParametersAreChecked)
{
  auto map = mapOf(plateWithHole());
  map.setCellSize(0.0);
  CellCloud cells;
  EXPECT_THROW(map.filter(cells), ParameterError);
}

TEST(CellGrid, AnUnorganisedMapIsRefused)
{
  CellCloud flat;
  flat.resize(10);
  EXPECT_THROW(CellGrid::of(flat), DataError);
}
