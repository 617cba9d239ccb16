// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "rough_job.h"

#include <pointmill/slice/occupancy_map.h>
#include <pointmill_test/clouds.h>

namespace bench {

using namespace pointmill;

Points::Ptr sample(const RoughPart& part, double step)
{
  return pointmill_test::surface({0, 0, part.length, part.width}, step, part.height);
}

RoughJob::RoughJob(const Points::Ptr& points, double margin, const RoughOptions& o)
    : options(o), map(new CellCloud)
{
  OccupancyMap<pcl::PointXYZ> occupancy;
  occupancy.setCellSize(o.cell);
  occupancy.setGapReach(2 * o.cell);
  occupancy.setInputCloud(points);
  occupancy.filter(*map);
  CellCloud bridges;
  for (const auto& cell : *map)
    if (cell.getState() == CellState::Between || cell.getState() == CellState::Gap)
      bridges.push_back(cell);
  part = std::make_shared<PointIndex>(
      std::vector<PointSource>{pointSource(*points), pointSource(bridges)});
  const Eigen::Vector3d low = part->min(), high = part->max();
  stock.min = low - Eigen::Vector3d(margin, margin, 1.0);
  stock.max = high + Eigen::Vector3d(margin, margin, o.above);
  floor = low.z();
}

Standing::Standing(const RoughJob& job)
    : bound(std::make_shared<StockField>(
          job.stock, job.options.cell, StockField::Bound::Upper)),
      nominal(std::make_shared<StockField>(
          job.stock, job.options.cell / 2, StockField::Bound::Nominal))
{
}

CLCloud
planPasses(LevelRoughing& roughing, const RoughJob& job, const Standing& standing)
{
  roughing.setTool(job.options.tool);
  roughing.setAllowance(job.options.allowance);
  roughing.setStepDown(job.options.step_down);
  roughing.setStepOver(job.options.step_over);
  roughing.setFloor(job.floor);
  roughing.setStock(standing.bound);
  roughing.setPart(job.part);
  roughing.setInputCloud(job.map);
  CLCloud passes;
  roughing.filter(passes);
  return passes;
}

CLCloud linkPasses(LinkPasses& linker,
                   const RoughJob& job,
                   const Standing& standing,
                   const CLCloud& passes)
{
  linker.setTool(job.options.tool);
  linker.setCutting(job.options.cutting);
  linker.setClearancePlane(job.stock.top() + job.options.clearance);
  linker.setStock(standing.bound);
  linker.setNominalStock(standing.nominal);
  linker.setPart(job.part, job.options.allowance, job.floor);
  linker.setStayDown(2 * job.options.tool.diameter);
  linker.setLeadRadius(job.options.tool.endDiameter() / 10);
  linker.setRapidRate(job.options.rapid_rate);
  linker.setLowRapids(true);
  linker.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  CLCloud path;
  linker.filter(path);
  return path;
}

} // namespace bench
