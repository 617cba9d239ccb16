// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the finishing operations cut, and how all are linked.
#include <pointmill/common/watch.h>
#include <pointmill/finish/buffer_points.h>
#include <pointmill/link/order_passes.h>
#include <pointmill/mill/mill_job.h>

#include <chrono>

namespace pointmill {
namespace {

/// Where of the work of finishing its passes end; the rest is linking them. And where
/// of the passes' the rows end, and where they have all their points.
constexpr double kPassesShare = 0.8, kRowsShare = 0.55, kPointsShare = 0.95;

} // namespace

void MillJob::link(PlannedOperation& planned, const CLCloud& passes, double lead_radius)
{
  LinkPasses linker;
  linker.setTool(planned.operation.tool);
  linker.setCutting(planned.operation.cutting);
  linker.setClearancePlane(clearancePlane());
  linker.setStock(standing_);
  linker.setNominalStock(nominal_);
  linker.setPart(surface_, planned.allowance, floor_);
  linker.setStayDown(2 * planned.operation.tool.diameter);
  linker.setLeadRadius(lead_radius);
  linker.setRapidRate(options_.machine.rapid_rate);
  linker.setLowRapids(true);
  linker.setKeepOut(options_.keep_out);
  linker.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  linker.filter(planned.operation.path);
  for (const auto& p : listParameters(linker))
    planned.parameters.push_back(p);
  for (const auto& f : linker.getReport().figures())
    planned.report.set("link_" + f.first, f.second);
  checkInterrupted();
  planned.figures = measurePath(
      planned.operation.path, options_.machine.rapid_rate, linker.getCutFigures());
  checkInterrupted();
  planned.volume_left = volumeLeft();
}

double MillJob::volumeLeft() const
{
  const CellGrid grid = CellGrid::of(*map_);
  double volume = 0;
  for (int row = 0; row < nominal_->rows(); ++row)
    for (int column = 0; column < nominal_->columns(); ++column) {
      const int c = grid.columnOf(nominal_->x(column));
      const int r = grid.rowOf(nominal_->y(row));
      double ground = floor_;
      if (grid.has(c, r) && map_->at(c, r).getState() != CellState::Empty)
        ground = std::max<double>(ground, map_->at(c, r).z);
      volume += std::max(0.0, nominal_->height(column, row) - ground);
    }
  return volume * nominal_->cellSize() * nominal_->cellSize();
}

CLCloud MillJob::rasterPasses(const ToolJob& job,
                              double scallop,
                              bool across,
                              PlannedOperation& planned) const
{
  CLSurface<pcl::PointXYZ> raster;
  raster.setTool(job.tool);
  raster.setScallop(scallop);
  // Rows nearer to each other would be on walls, where a raster across does better.
  raster.setMinStepOver(raster.getStepOver() / 4);
  raster.setForwardStep(job.tool.endDiameter() / 6);
  raster.setAllowance(job.allowance);
  raster.setFloor(floor_);
  raster.setDirection(options_.raster);
  raster.setAcross(across);
  raster.setPattern(options_.pattern);
  raster.setMillingMode(options_.milling);
  if (!options_.boundary.empty())
    raster.setBoundary(options_.boundary);
  else if (options_.over_stock)
    raster.setBoundary(stock_);
  raster.setOverhang(options_.overhang);
  raster.setKeepOut(options_.keep_out);
  raster.setModel(model_);
  raster.setNumberOfThreads(options_.threads);

  const double chord = ErrorBudget::of(options_.tolerance).chord;
  BufferPoints<pcl::PointXYZ> buffer;
  buffer.setModel(model_);
  buffer.setTool(job.tool);
  buffer.setAllowance(job.allowance);
  buffer.setFloor(floor_);
  // Over sparse points chords would cut into every one that they may: less inside. The
  // fine chords become arcs when the program is written.
  buffer.setTolerance({2 * chord / 3, chord});
  buffer.setNumberOfThreads(options_.threads);

  CLCloud::Ptr rows(new CLCloud);
  raster.setInputCloud(clean_);
  {
    const WorkStep step({0.0, kRowsShare});
    raster.filter(*rows);
  }
  planned.parameters = listParameters(raster);
  const auto report = [&](const std::string& stage, const Report& figures) {
    for (const auto& f : figures.figures())
      planned.report.set(stage + f.first, f.second);
  };
  report("raster_", raster.getReport());
  if (rows->empty())
    return {};
  auto passes = [&] {
    const WorkStep step({kRowsShare, kPointsShare});
    return pointmill::run<PointCL>(rows, buffer);
  }();
  report("buffer_", buffer.getReport());
  if (options_.pattern == RasterPattern::ZigZag) { // others must not be turned round
    const WorkStep step({kPointsShare, 1.0});
    OrderPasses order;
    passes = pointmill::run<PointCL>(passes, order);
    report("order_", order.getReport());
  }
  for (const auto& p : listParameters(buffer))
    if (p.name != "allowance")
      planned.parameters.push_back(p);
  return *passes;
}

void MillJob::planFinishing(const ToolJob& job,
                            const std::string& name,
                            double scallop,
                            bool across)
{
  PlannedOperation planned(job, name);
  const auto start = std::chrono::steady_clock::now();
  const CLCloud passes = [&] {
    const WorkStep step({0.0, kPassesShare});
    return rasterPasses(job, scallop, across, planned);
  }();
  if (passes.empty())
    throw DataError(name + ": no row lies over the part: look at the boundary" +
                    (options_.keep_out.empty() ? "" : " and at the keep-out zones"));
  const WorkStep step({kPassesShare, 1.0});
  link(planned, passes, 0.0);
  planned.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  operations_.push_back(std::move(planned));
}

} // namespace pointmill
