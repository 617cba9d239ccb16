// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/rough/grid_roughing.h>
#include <pointmill/rough/high_speed_roughing.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/rough/spiral_roughing.h>
#include <pointmill/rough/zigzag_roughing.h>
#include <pointmill/slice/occupancy_map.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

#include <set>

namespace rough_test {

using namespace pointmill;
using namespace pointmill_test;

inline CellCloud::Ptr
mapOf(const Cloud::Ptr& cloud, double cell, GapPolicy policy = GapPolicy::Bridge)
{
  OccupancyMap<pcl::PointXYZ> occupancy;
  occupancy.setCellSize(cell);
  occupancy.setGapReach(2 * cell);
  occupancy.setGapPolicy(policy);
  occupancy.setInputCloud(cloud);
  CellCloud::Ptr map(new CellCloud);
  occupancy.filter(*map);
  return map;
}

inline std::shared_ptr<StockField>
block(const Rectangle& area, double bottom, double top, double cell = 0.25)
{
  return std::make_shared<StockField>(
      Stock{{area.x0, area.y0, bottom}, {area.x1, area.y1, top}},
      cell,
      StockField::Bound::Upper);
}

/// What stands of the stock after the passes, exact at the centres of the cells.
inline StockField
simulate(const CLCloud& passes, const Tool& tool, const Stock& stock, double cell)
{
  StockField field(stock, cell, StockField::Bound::Nominal);
  forMovesOfPasses(passes, [&](const auto& a, const auto& b, const PointCL&) {
    field.cut(tool, a, b);
  });
  return field;
}

/// Distance from @p p to the surface of a tool that moves level from @p a to @p b;
/// negative inside.
inline double distanceToSweep(const CutterProfile& profile,
                              const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b,
                              const Eigen::Vector3d& p)
{
  const Eigen::Vector2d along = (b - a).head<2>(), to = (p - a).head<2>();
  const double len2 = along.squaredNorm();
  const double t = len2 > 0 ? std::min(1.0, std::max(0.0, to.dot(along) / len2)) : 0.0;
  return -profile.depth((to - t * along).norm(), p.z() - a.z());
}

/// The least of it over all moves of the passes and all points; a move that is not
/// level is taken as many short ones. `level`: there must be none of those.
inline double
clearance(const CLCloud& passes, const Tool& tool, brute::Points points, bool level)
{
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x();
  });
  const auto left_of = [](const Eigen::Vector3d& p, double x) { return p.x() < x; };
  const CutterProfile profile = tool.profile();
  double least = std::numeric_limits<double>::infinity();
  forMovesOfPasses(
      passes,
      [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const PointCL& how) {
        if (level && how.getMotion() != Motion::Ramp) {
          EXPECT_EQ(a.z(), b.z()) << "a pass of roughing leaves its level";
        }
        const double near = (b - a).norm() + tool.radius() + 1;
        const auto first =
            std::lower_bound(points.begin(), points.end(), a.x() - near, left_of);
        const int pieces =
            a.z() == b.z() ? 1 : 1 + static_cast<int>((b - a).norm() / 0.05);
        for (int i = 0; i < pieces; ++i) {
          const Eigen::Vector3d from = a + (b - a) * (double(i) / pieces);
          Eigen::Vector3d to = a + (b - a) * (double(i + 1) / pieces);
          to.z() = from.z();
          for (auto p = first; p != points.end() && p->x() <= a.x() + near; ++p)
            if (p->z() > from.z() - 5 && std::abs(p->y() - a.y()) <= near)
              least = std::min(least, distanceToSweep(profile, from, to, *p));
        }
      });
  return least;
}

/// Calls visit(x, y, height) for every cell of the field.
template <typename Visit>
void forCells(const StockField& field, Visit&& visit)
{
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 0; column < field.columns(); ++column)
      visit(field.x(column), field.y(row), field.height(column, row));
}

inline double volumeRemoved(const StockField& field)
{
  double volume = 0;
  forCells(field, [&](double, double, double h) {
    volume += (field.stock().top() - h) * field.cellSize() * field.cellSize();
  });
  return volume;
}

/// Fixture of what all strategies must do.
template <typename Strategy>
class EveryRoughing : public ::testing::Test {
protected:
  Strategy roughing;
  /// Whether every pass stays on its level; the grid's climb.
  static constexpr bool kLevel = !std::is_same<Strategy, GridRoughing>::value;

  void set(const Tool& tool, double allowance, double step_down, double step_over)
  {
    roughing.setTool(tool);
    roughing.setAllowance(allowance);
    roughing.setStepDown(step_down);
    roughing.setStepOver(step_over);
  }
  CLCloud run(const CellCloud::ConstPtr& map)
  {
    CLCloud passes;
    roughing.setInputCloud(map);
    roughing.filter(passes);
    return passes;
  }
  double
  clearance(const CLCloud& passes, const Tool& tool, const brute::Points& points) const
  {
    return rough_test::clearance(passes, tool, points, kLevel);
  }
};

using Strategies = ::testing::Types<ZigZagRoughing,
                                    SpiralRoughing,
                                    GridRoughing,
                                    OffsetRoughing,
                                    HighSpeedRoughing>;

struct StrategyNames {
  template <typename T>
  static std::string GetName(int)
  {
    const std::string name = T().getName();
    return name.substr(0, name.find("Roughing"));
  }
};

} // namespace rough_test
