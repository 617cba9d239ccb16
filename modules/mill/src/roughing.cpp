// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the roughing operations cut, from the big tool to the skins on the walls.
#include <pointmill/common/watch.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/rough/grid_roughing.h>
#include <pointmill/rough/high_speed_roughing.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/rough/spiral_roughing.h>
#include <pointmill/rough/waterline_roughing.h>
#include <pointmill/rough/zigzag_roughing.h>
#include <pointmill/slice/z_slices.h>

#include <chrono>
#include <cmath>

namespace pointmill {
namespace {

/// Rest roughing leaves what stands less than so high, or is a skin narrower than so,
/// in diameters of the tool's end.
constexpr double kRestThickness = 0.4, kRestWidth = 0.6;
/// Skins higher than this are taken down from the walls by steps of it [diameters].
constexpr double kWallStep = 0.5;
/// Thinner skins are left [diameters].
constexpr double kMinSkin = 0.05;
/// Of the allowance stays after that: the passes beside meet no skin then.
constexpr double kWallAllowance = 0.75;
/// Radius of the arcs that lead into and out of passes [diameters].
constexpr double kLeadRadius = 0.1;

/// What the levels are of the work; the rest is linking their passes.
constexpr double kLevelsShare = 0.6;

/// Calls plan(roughing) with the strategy of that name.
template <typename Plan>
void withStrategy(RoughingStrategy strategy, Plan&& plan)
{
  const auto call = [&](auto roughing) { plan(roughing); };
  switch (strategy) {
  case RoughingStrategy::Grid:
    return call(GridRoughing());
  case RoughingStrategy::ZigZag:
    return call(ZigZagRoughing());
  case RoughingStrategy::Spiral:
    return call(SpiralRoughing());
  case RoughingStrategy::HighSpeed:
    return call(HighSpeedRoughing());
  case RoughingStrategy::Offset:
    return call(OffsetRoughing());
  }
}

} // namespace

template <typename Strategy>
void MillJob::planLevels(Strategy& roughing,
                         const ToolJob& job,
                         const std::string& name)
{
  PlannedOperation planned(job, name);
  roughing.setTool(job.tool);
  roughing.setAllowance(job.allowance);
  roughing.setFloor(floor_);
  roughing.setStock(standing_);
  roughing.setPart(surface_);
  roughing.setKeepOut(options_.keep_out);
  roughing.setNumberOfThreads(options_.threads);
  roughing.setInputCloud(map_);
  CLCloud passes;
  const auto start = std::chrono::steady_clock::now();
  {
    const WorkStep step({0.0, kLevelsShare});
    roughing.filter(passes);
  }
  planned.parameters = listParameters(roughing);
  planned.report = roughing.getReport();
  planned.narrow = roughing.getNarrowPlaces();
  const WorkStep step({kLevelsShare, 1.0});
  if (!passes.empty())
    link(planned, passes, kLeadRadius * job.tool.endDiameter());
  if (planned.operation.path.empty()) { // nothing that is worth this tool's while
    idle_.push_back(std::move(planned));
    return;
  }
  planned.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  operations_.push_back(std::move(planned));
}

void MillJob::planRoughing()
{
  const Tool& tool = options_.rough.tool;
  withStrategy(options_.roughing, [&](auto& roughing) {
    roughing.setStepDown(options_.step_down);
    roughing.setStepOver(options_.stepOver());
    roughing.setMinFlat(std::isnan(options_.min_flat)
                            ? tool.endDiameter() * tool.endDiameter()
                            : options_.min_flat);
    planLevels(roughing, options_.rough, "roughing");
  });
}

void MillJob::planRest(const ToolJob& job, const std::string& name)
{
  const double end = job.tool.endDiameter();
  OffsetRoughing rest; // what is left are small places: contours are shortest there
  rest.setStepOver(kRoughStepOver * end);
  rest.setRestLimits(kRestThickness * end, kRestWidth * end);
  planLevels(rest, job, name);
}

void MillJob::planWalls(ToolJob job, const std::string& name)
{
  const double end = job.tool.endDiameter();
  job.allowance *= kWallAllowance;
  WaterlineRoughing walls;
  walls.setStepDown(kWallStep * end);
  walls.setStepOver(kRoughStepOver * end);
  walls.setNominalStock(nominal_);
  walls.setMinSkin(kMinSkin * end);
  planLevels(walls, job, name);
}

} // namespace pointmill
