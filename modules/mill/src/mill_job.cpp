// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/finish/buffer_points.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/io/raw_scan.h>
#include <pointmill/io/scan.h>
#include <pointmill/link/order_passes.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/rough/level_roughing.h>
#include <pointmill/slice/z_slices.h>

#include <pcl/filters/radius_outlier_removal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace pointmill {
namespace {

/// Parts outside this are taken for a slip of units [mm].
constexpr double kSmallestPart = 1.0, kLargestPart = 3000.0;
constexpr double kMostCells = 1e6;    // of the map, by default
constexpr double kMostStrays = 0.005; // share of the points
constexpr std::size_t kMostSamples = 6'000'000;

std::string length(double mm)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  if (mm >= 1000)
    text << mm / 1000 << " m";
  else
    text << mm << " mm";
  return text.str();
}

} // namespace

void MillJob::timed(const std::string& stage,
                    double done,
                    const std::function<void()>& work)
{
  if (progress_)
    progress_(stage, done);
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  seconds_.emplace_back(stage, took.count());
}

double MillJob::gapArea() const
{
  double area = 0;
  for (const auto& gap : gaps_)
    area += gap.area;
  return area;
}

double MillJob::sinkBetweenPoints() const
{
  const double r = options_.finish.tool.radius();
  const double half = scan_.spacing.p99 * scan_.spacing.p99 / 2;
  return r - std::sqrt(std::max(0.0, r * r - half));
}

double MillJob::minutes() const
{
  double sum = 0;
  for (const auto& o : operations_)
    sum += o.figures.minutes;
  return sum;
}

void MillJob::readAndAlign(const std::string& scan)
{
  RawScan raw;
  timed("read", 0.0, [&] { raw = readScan(scan); });

  Scan prepared;
  timed("prepare", 0.03, [&] {
    // Samples so near that the finest tool sinks less than a tenth of the tolerance
    // between them: R - sqrt(R^2 - s^2 / 2) at the middle of a square of edge s.
    const double sink = options_.tolerance / 10;
    const double spacing = std::sqrt(4 * options_.finish.tool.radius() * sink);
    prepared = prepareScan(raw,
                           {options_.mm_per_unit, options_.fit},
                           1.0 / (spacing * spacing),
                           kMostSamples,
                           options_.seed);
  });
  scan_.format = prepared.format;
  scan_.vertices = prepared.vertices;
  scan_.faces = prepared.faces;
  scan_.sampled = prepared.sampled;
  scan_.nan_points = prepared.non_finite;
  scan_.scale = prepared.scale;

  timed("align", 0.06, [&] {
    ZAlignment<pcl::PointXYZ> align;
    align.setUp(options_.up);
    align.setSquareToX(options_.square);
    align.setDatumXY(options_.datum_xy);
    align.setDatumZ(options_.datum_z);
    const auto run = [&](const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud) {
      part_.reset(new pcl::PointCloud<pcl::PointXYZ>);
      align.setInputCloud(cloud);
      align.filter(*part_);
      return align.getTransform();
    };
    Eigen::Matrix4d to_part = run(prepared.cloud);
    const double largest = align.getExtents().maxCoeff();
    if (largest < kSmallestPart || largest > kLargestPart)
      throw DataError("the part would be " + length(largest) +
                      " long: say its units (--units mm|cm|m|inch) or the size that it "
                      "is to have (--fit MM)");
    scan_.spacing = measureSpacing(*part_, options_.seed);
    if (options_.remove_strays) {
      // A scan's points have company; dust, reflections and mixed pixels do not.
      pcl::RadiusOutlierRemoval<pcl::PointXYZ> company;
      company.setRadiusSearch(6 * std::max(scan_.spacing.median, 1e-3));
      company.setMinNeighborsInRadius(6);
      company.setInputCloud(part_);
      pcl::PointCloud<pcl::PointXYZ>::Ptr kept(new pcl::PointCloud<pcl::PointXYZ>);
      company.filter(*kept);
      // More than a few are no strays: the scan is like that, and taking real surface
      // away would let the tool cut there.
      const std::size_t lonely = part_->size() - kept->size();
      if (lonely > 0 && lonely <= part_->size() * kMostStrays) {
        scan_.strays = lonely; // and the datum may have hung on one
        align.setUp(Up::Z);
        to_part = run(kept) * to_part;
      }
    }
    Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
    back.block<3, 1>(0, 3) = -prepared.shift;
    alignment_ = to_part * back;
  });
}

void MillJob::makeMap()
{
  timed("map", 0.1, [&] {
    const double void_between = std::max(scan_.spacing.median, 1e-3);
    double cell = options_.cell;
    if (cell <= 0)
      cell = options_.rough.tool.diameter / 20;
    // A very large part gets coarser cells rather than hours.
    const Eigen::Vector4f size =
        part_->getMatrixXfMap().rowwise().maxCoeff().head<4>() -
        part_->getMatrixXfMap().rowwise().minCoeff().head<4>();
    if (options_.cell <= 0)
      cell = std::max(cell, std::sqrt(double(size.x()) * size.y() / kMostCells));
    OccupancyMap<pcl::PointXYZ> occupancy;
    occupancy.setCellSize(cell);
    occupancy.setGapReach(std::max(1.5 * cell, 2.5 * void_between));
    occupancy.setGapPolicy(options_.gaps);
    occupancy.setInputCloud(part_);
    map_.reset(new CellCloud);
    occupancy.filter(*map_);
    gaps_ = occupancy.getGaps();

    CellCloud bridges;
    for (const auto& c : *map_) {
      if (c.getState() == CellState::Gap)
        bridges.push_back(c);
    }
    pcl::Indices all(part_->size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<pcl::index_t>(i);
    points_ = std::make_shared<PointIndex>(makePointIndex(*part_, all, CellCloud()));
    surface_ = points_;
    bridges_.reset();
    if (!bridges.empty()) {
      surface_ = std::make_shared<PointIndex>(makePointIndex(*part_, all, bridges));
      bridges_ = std::make_shared<PointIndex>(
          makePointIndex(bridges, pcl::Indices(), bridges));
    }

    model_ = std::make_shared<SurfaceModel>(surface_);

    const double margin = options_.stock_margin;
    floor_ = std::isnan(options_.floor) ? points_->min().z() : options_.floor;
    bridged_area_ = occupancy.getReport().get("between_points_mm2");
    stock_.min =
        points_->min() - Eigen::Vector3d(margin, margin, options_.stock_bottom);
    stock_.max = points_->max() + Eigen::Vector3d(margin, margin, options_.stock_top);
    if (floor_ < stock_.min.z() - 1e-6)
      throw ParameterError("mill: --floor lies below the stock's bottom, Z" +
                           std::to_string(stock_.min.z()));
    if (stock_.max.z() - floor_ < 1e-3)
      throw DataError("the part is flat: there is nothing to mill");
    standing_ = std::make_shared<StockField>(stock_, cell, StockField::Bound::Upper);
    nominal_ =
        std::make_shared<StockField>(stock_, cell / 2, StockField::Bound::Nominal);
  });
}

void MillJob::link(PlannedOperation& planned, const CLCloud& passes)
{
  LinkPasses linker;
  linker.setTool(planned.operation.tool);
  linker.setCutting(planned.operation.cutting);
  linker.setClearancePlane(clearancePlane());
  linker.setStock(standing_);
  linker.setNominalStock(nominal_);
  linker.setPart(surface_, planned.allowance, floor_);
  linker.setStayDown(2 * planned.operation.tool.diameter);
  linker.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  linker.filter(planned.operation.path);
  for (const auto& p : listParameters(linker))
    planned.parameters.push_back(p);
  for (const auto& f : linker.getReport().figures())
    planned.report.set("link_" + f.first, f.second);
  planned.figures = measurePath(planned.operation.path, options_.rapid_rate);
}

void MillJob::planRoughing(const ToolJob& job,
                           const std::string& name,
                           double min_thickness)
{
  PlannedOperation planned;
  planned.operation.name = name;
  planned.operation.tool = job.tool;
  planned.operation.cutting = job.cutting;
  planned.allowance = job.allowance;
  planned.colour = min_thickness <= 0                             ? 0
                   : job.tool.number == options_.semi.tool.number ? 1
                                                                  : 3;

  ZigZagRoughing zigzag;
  SpiralRoughing spiral;
  LevelRoughing& roughing = options_.roughing == RoughingStrategy::Spiral
                                ? static_cast<LevelRoughing&>(spiral)
                                : zigzag;
  roughing.setTool(job.tool);
  roughing.setAllowance(job.allowance);
  roughing.setStepDown(min_thickness <= 0 && options_.step_down > 0
                           ? options_.step_down
                           : ZSlices::pitchForDiameter(job.tool.diameter));
  roughing.setStepOver(options_.step_over > 0 && min_thickness <= 0
                           ? options_.step_over
                           : 0.4 * job.tool.diameter);
  roughing.setFloor(floor_);
  roughing.setStock(standing_);
  roughing.setPart(surface_);
  roughing.setRestLimits(min_thickness,
                         min_thickness > 0 ? 0.6 * job.tool.diameter : 0.0);
  roughing.setNumberOfThreads(options_.threads);
  roughing.setInputCloud(map_);
  CLCloud passes;
  const auto start = std::chrono::steady_clock::now();
  roughing.filter(passes);
  planned.parameters = listParameters(roughing);
  planned.report = roughing.getReport();
  if (passes.empty()) // nothing that is worth this tool's while
    return;
  link(planned, passes);
  if (planned.operation.path.empty())
    return;
  planned.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  operations_.push_back(std::move(planned));
}

CLCloud MillJob::rasterPasses(const ToolJob& job,
                              double scallop,
                              bool across,
                              PlannedOperation& planned) const
{
  CLSurface<pcl::PointXYZ> raster;
  raster.setTool(job.tool);
  raster.setScallop(scallop);
  raster.setForwardStep(job.tool.radius() / 3);
  raster.setAllowance(job.allowance);
  raster.setFloor(floor_);
  raster.setDirection(options_.raster);
  raster.setAcross(across);
  raster.setModel(model_);
  raster.setNumberOfThreads(options_.threads);

  BufferPoints<pcl::PointXYZ> buffer;
  buffer.setModel(model_);
  buffer.setTool(job.tool);
  buffer.setAllowance(job.allowance);
  buffer.setFloor(floor_);
  buffer.setTolerance(ErrorBudget::of(options_.tolerance).chord);
  buffer.setNumberOfThreads(options_.threads);

  CLCloud::Ptr lines(new CLCloud);
  raster.setInputCloud(part_);
  raster.filter(*lines);
  for (const auto& f : raster.getReport().figures())
    planned.report.set("raster_" + f.first, f.second);
  OrderPasses order;
  const CLCloud passes = *pointmill::run<PointCL>(lines, buffer, order);
  for (const auto& f : order.getReport().figures())
    planned.report.set("order_" + f.first, f.second);
  for (const auto& f : buffer.getReport().figures())
    planned.report.set("buffer_" + f.first, f.second);
  planned.parameters = listParameters(raster);
  for (const auto& p : listParameters(buffer))
    if (p.name != "allowance")
      planned.parameters.push_back(p);
  return passes;
}

void MillJob::planFinishing(const ToolJob& job,
                            const std::string& name,
                            double scallop,
                            bool steep_too)
{
  PlannedOperation planned;
  planned.operation.name = name;
  planned.operation.tool = job.tool;
  planned.operation.cutting = job.cutting;
  planned.allowance = job.allowance;
  planned.colour = steep_too ? 4 : 2;
  const auto start = std::chrono::steady_clock::now();

  const CLCloud passes =
      rasterPasses(job, scallop, steep_too && options_.steep > 0, planned);
  link(planned, passes);
  planned.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  operations_.push_back(std::move(planned));
}

std::vector<std::string> MillJob::setUp() const
{
  const auto range = [&](const char* axis, int i) {
    char text[64];
    std::snprintf(
        text, sizeof text, " %s%.3f to %.3f", axis, stock_.min[i], stock_.max[i]);
    return std::string(text);
  };
  char text[80];
  std::snprintf(text,
                sizeof text,
                "lowest tip Z%.3f, stock bottom Z%.3f, clearance plane Z%.3f",
                floor_,
                stock_.min.z(),
                clearancePlane());
  return {"stock mm" + range("X", 0) + range("Y", 1) + range("Z", 2),
          std::string("X0 Y0 is the ") +
              (options_.datum_xy == DatumXY::Corner ? "corner" : "centre") +
              " of the part's box, Z0 its " +
              (options_.datum_z == DatumZ::Top ? "top" : "bottom"),
          text};
}

void MillJob::writeProgram()
{
  const ErrorBudget budget = ErrorBudget::of(options_.tolerance);
  GCodeWriter writer;
  writer.addComment("part " + scan_name_);
  for (const auto& line : setUp())
    writer.addComment(line);
  writer.setClearancePlane(clearancePlane());
  writer.setPathTolerance(budget.blend);
  std::vector<Operation> operations;
  std::uint32_t passes = 0;
  for (auto& o : operations_) { // pass numbers run through the whole program
    std::uint32_t last = passes;
    for (auto& p : o.operation.path) {
      p.label += passes;
      last = std::max(last, p.label + 1);
    }
    passes = last;
    operations.push_back(o.operation);
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  writer.write(operations, text);
  program_ = text.str();
}

void MillJob::verify()
{
  std::istringstream text(program_);
  const Program read_back = readProgram(text);
  ProgramVerifier verifier;
  verifier.setPart(points_);
  verifier.setStock(stock_);
  verifier.setTools({options_.rough.tool, options_.semi.tool, options_.finish.tool});
  // What the control may add by blending corners cannot be seen in the text.
  verifier.setTolerance(options_.tolerance - ErrorBudget::of(options_.tolerance).blend);
  verifier.setResidualLimit(options_.residual_limit);
  const Eigen::Vector3d size = stock_.max - stock_.min;
  // Cells no wider than the thinnest tool's radius: nothing slips between two centres.
  const double thinnest = std::min({options_.rough.tool.radius(),
                                    options_.semi.tool.radius(),
                                    options_.finish.tool.radius()});
  verifier.setCellSize(
      std::min(std::max(0.25, std::sqrt(size.x() * size.y() / 4e6)), thinnest / 2));
  verifier.setFloor(floor_);
  verifier.setProtected(bridges_);
  verifier.setBlendLimit(ErrorBudget::of(options_.tolerance).blend + 1e-9);
  verifier.setNumberOfThreads(options_.threads);
  verification_ = verifier.verify(read_back);
  if (!verification_.good()) {
    std::string why = "the program fails its verification and was not written:";
    for (const auto& f : verification_.findings)
      why +=
          " " + f.text + (f.line ? " (line " + std::to_string(f.line) + ")" : "") + ";";
    why.pop_back();
    throw VerificationError(why);
  }
}

void MillJob::plan(const std::string& scan)
{
  options_.validate();
  passed_ = false;
  scan_path_ = scan;
  scan_name_ = std::filesystem::path(scan).filename().string();
  operations_.clear();
  seconds_.clear();
  readAndAlign(scan);
  makeMap();
  timed("roughing", 0.15, [&] { planRoughing(options_.rough, "roughing", 0.0); });
  // Where the big tool did not get in, full stock stands: a ball end mill must not go
  // there in one pass.
  ToolJob rest = options_.semi;
  rest.allowance = std::max(rest.allowance, 0.6 * options_.rough.allowance);
  timed("rest roughing", 0.25, [&] {
    planRoughing(rest, "rest roughing", 0.4 * rest.tool.diameter);
  });
  timed("semi-finishing", 0.35, [&] {
    planFinishing(options_.semi, "semi-finishing", options_.semi_scallop, false);
  });
  rest = options_.finish;
  rest.allowance = std::max(rest.allowance, options_.semi.allowance);
  timed("rest roughing, fine", 0.45, [&] {
    planRoughing(rest, "rest roughing, fine", 0.4 * rest.tool.diameter);
  });
  timed("finishing", 0.5, [&] {
    planFinishing(options_.finish, "finishing", options_.scallop, true);
  });
  timed("write", 0.65, [&] { writeProgram(); });
  timed("verify", 0.7, [&] { verify(); });
  passed_ = true;
}

} // namespace pointmill
