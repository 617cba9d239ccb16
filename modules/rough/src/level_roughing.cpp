// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "out_of_reach.h"
#include "planes.h"
#include "region_order.h"

#include <pointmill/common/parallel.h>
#include <pointmill/rough/level_roughing.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// The heights that the map's part spans.
std::pair<double, double> extentOf(const CellCloud& map, const std::string& who)
{
  double top = -std::numeric_limits<double>::infinity(), bottom = -top;
  for (const auto& cell : map)
    if (cell.getState() != CellState::Empty) {
      top = std::max<double>(top, cell.z);
      bottom = std::min<double>(bottom, cell.z);
    }
  if (!(top >= bottom))
    throw DataError(who + ": the map holds no part");
  return {bottom, top};
}

/// What maps and levels are of the work; the rest is their order.
constexpr double kMapShare = 0.3, kLevelsShare = 0.95;

double away(const Eigen::Vector3d& from, const PathPoint& to)
{
  return (from - to.at).head<2>().norm();
}

void append(CLCloud& cloud, const RoughPass& pass, std::uint32_t label)
{
  for (const auto& point : pass.path.points) {
    PointCL p(point.at.x(), point.at.y(), point.at.z(), point.motion);
    p.label = label;
    p.level = static_cast<std::uint32_t>(pass.level);
    cloud.push_back(p);
  }
}

} // namespace

void LevelRoughing::checkParameters() const
{
  validateParameters(*this, getName());
  tool_.validate();
  if (step_over_ > tool_.endDiameter())
    throw ParameterError(getName() + ": the step-over is wider than the tool's end");
}

void LevelRoughing::apply(CLCloud& output)
{
  narrow_.clear();
  if (indices_->size() != input_->size())
    throw DataError(getName() + ": a map is roughed as a whole; it takes no indices");
  const CellGrid cells = CellGrid::of(*input_);
  const auto [bottom, top] = extentOf(*input_, getName());
  auto stock = stock_;
  if (!stock)
    stock = std::make_shared<StockField>(Stock{{cells.x0, cells.y0, bottom - 1.0},
                                               {cells.x0 + cells.columns * cells.cell,
                                                cells.y0 + cells.rows * cells.cell,
                                                top}},
                                         cells.cell,
                                         StockField::Bound::Upper);
  const double floor = std::isnan(floor_) ? bottom : floor_;
  const double depth = stock->stock().top() - floor;
  if (depth >= 0 && depth < 1e-3) { // a flat plate: there is nothing to rough
    report_.set("levels", 0);
    return;
  }
  const auto map = [&] {
    const WorkStep step({0.0, kMapShare});
    return LevelMap(*input_,
                    part_.get(),
                    *stock,
                    {tool_, allowance_, min_thickness_, min_width_, keep_out_},
                    threads_);
  }();
  const auto planes = planesOf(map, floor, stock->stock().top(), stepDown(), min_flat_);

  struct Work {
    std::vector<LevelPath> paths;
    Report figures;
    double left = 0; // mm2
  };
  std::vector<Work> work(planes.size());
  const auto regions = map.regions(planes.back().z);
  parallelFor(planes.size(), threads_, {kMapShare, kLevelsShare}, [&](std::size_t k) {
    const Level level(map, planes[k].z, step_over_, planes[k].below, &regions);
    if (level.isEmpty())
      return;
    work[k].paths = clearLevel(level, work[k].figures);
    Material material(level);
    for (const auto& path : work[k].paths)
      material.cut(path);
    auto rest = clearRest(level, material);
    std::move(rest.begin(), rest.end(), std::back_inserter(work[k].paths));
    work[k].left =
        double(material.left()) * material.grid().cell * material.grid().cell;
  });

  std::vector<RoughPass> passes;
  std::size_t used = 0, flats = 0;
  double left = 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    used += !work[k].paths.empty();
    left += work[k].left;
    flats += std::isfinite(planes[k].below);
    for (const auto& [name, value] : work[k].figures.figures())
      report_.set(name, report_.get(name) + value);
    for (auto& path : work[k].paths)
      if (!path.points.empty())
        passes.push_back({std::move(path), k});
  }
  std::uint32_t label = 0;
  Eigen::Vector3d at;
  for (const std::size_t i : byRegion(map, regions, passes)) {
    RoughPass& pass = passes[i];
    auto& points = pass.path.points;
    if (label > 0 && pass.path.reversible &&
        away(at, points.back()) < away(at, points.front()))
      std::reverse(points.begin(), points.end());
    at = points.back().at;
    append(output, pass, label++);
  }
  report_.set("levels", static_cast<double>(planes.size()));
  report_.set("levels_on_flats", static_cast<double>(flats));
  report_.set("levels_cut", static_cast<double>(used));
  report_.set("passes", label);
  report_.set("cl_points", static_cast<double>(output.size()));
  const OutOfReach out = outOfReach(map, *input_, allowance_, floor, 2 * stepDown());
  narrow_ = out.narrow;
  report_.set("narrow_places", static_cast<double>(out.narrow.size()));
  report_.set("narrow_mm3", out.narrow_volume);
  report_.set("kept_out_mm3", out.kept_out_volume);
  report_.set("missed_mm2", left);
}

} // namespace pointmill
