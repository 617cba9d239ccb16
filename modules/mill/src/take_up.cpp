// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// From the file of a scan to the surface that is to be milled.
#include <pointmill/align/strays.h>
#include <pointmill/common/watch.h>
#include <pointmill/io/raw_scan.h>
#include <pointmill/io/scan.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/noise.h>
#include <pointmill/slice/sink.h>
#include <pointmill/slice/spacing_map.h>
#include <pointmill/surface/point_smoother.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace pointmill {
namespace {

/// Parts outside this are taken for a slip of units [mm].
constexpr double kSmallestPart = 1.0, kLargestPart = 3000.0;
constexpr double kMostCells = 1e6;    // of the map, by default
constexpr double kMostStrays = 0.005; // share of the points

/// Noise and sinking under this share of the tolerance are left alone.
constexpr double kLittle = 0.1;
/// What smoothing aims to leave of the noise, as a share of the tolerance.
constexpr double kNoiseLeft = 0.15;
/// Smoothing raises no point by more than this share of the tolerance.
constexpr double kMostRaised = 0.8;
constexpr double kFewestNeighbours = 24, kMostNeighbours = 120;
/// Points may lie this share of the tolerance off a patch of the smooth surface.
constexpr double kFidelity = 0.25;

/// To measure the noise is this share of the work of taking it off.
constexpr double kNoiseShare = 0.2;

/// Voids between points this far from the next one are bridged, in radii of the last
/// tool: nearer by, quadrics through the points hold it up.
constexpr double kWideVoid = 0.5;

/// From each cell of a map to the next one that holds points, in cells.
std::vector<float> distanceToPoints(const CellCloud& map)
{
  std::vector<unsigned char> occupied(map.size());
  std::transform(map.begin(), map.end(), occupied.begin(), [](const PointCell& c) {
    return static_cast<unsigned char>(c.getState() == CellState::Occupied);
  });
  return distanceField(
      occupied, static_cast<int>(map.width), static_cast<int>(map.height));
}

template <typename PointT>
pcl::Indices all(const pcl::PointCloud<PointT>& cloud)
{
  pcl::Indices indices(cloud.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

template <typename PointT>
PointIndex indexOf(const pcl::PointCloud<PointT>& cloud, const CellCloud& fill = {})
{
  return makePointIndex(cloud, all(cloud), fill);
}

std::string at(const Eigen::Vector2d& place)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << "X" << place.x() << " Y" << place.y();
  return text.str();
}

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

void MillJob::readAndAlign(const std::string& scan)
{
  RawScan raw;
  timed("read", [&] { raw = readScan(scan); });

  Scan prepared;
  timed("prepare", [&] {
    // Samples so near that the finest tool sinks less than a tenth of the tolerance
    // between them: R - sqrt(R^2 - s^2 / 2) at the middle of a square of edge s.
    const double sink = options_.tolerance / 10;
    const double spacing = std::sqrt(4 * options_.finish.tool.corner_radius * sink);
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

  timed("align", [&] {
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
      const pcl::Indices kept = pointsInCompany(
          *part_, 6 * std::max(scan_.spacing.median, 1e-3), 6, options_.threads);
      // More than a few are no strays: the scan is like that, and taking real surface
      // away would let the tool cut there.
      const std::size_t lonely = part_->size() - kept.size();
      if (lonely > 0 && lonely <= part_->size() * kMostStrays) {
        scan_.strays = lonely; // and the datum may have hung on one
        align.setUp(Up::Z);
        to_part = run(pcl::PointCloud<pcl::PointXYZ>::ConstPtr(
                      new pcl::PointCloud<pcl::PointXYZ>(*part_, kept))) *
                  to_part;
      }
    }
    Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
    back.block<3, 1>(0, 3) = -prepared.shift;
    alignment_ = to_part * back;
  });
}

void MillJob::makeSurface()
{
  timed("surface", [&] {
    points_ = std::make_shared<PointIndex>(indexOf(*part_));
    figures_ = SurfaceFigures();
    {
      const WorkStep step({0.0, kNoiseShare});
      figures_.noise = std::isnan(options_.noise)
                           ? measureNoise(*part_, options_.seed).deviation
                           : options_.noise;
    }
    const Tool& last = options_.finish.tool;
    const double sink = sinkBetweenPoints(last, scan_.spacing.p99);
    const bool noisy = figures_.noise > kLittle * options_.tolerance;
    figures_.smooth = options_.surface == SurfaceChoice::Smooth ||
                      (options_.surface == SurfaceChoice::Auto &&
                       (noisy || sink > kLittle * options_.tolerance));
    if (!figures_.smooth && sink > options_.tolerance && !options_.accept_sparse)
      throw DataError("the scan is too sparse for bare points: they lie up to " +
                      length(scan_.spacing.p99) + " apart, where " + last.describe() +
                      " may sink " + length(sink) +
                      " below the surface, and --tolerance is " +
                      length(options_.tolerance) + " (the widest place is at " +
                      at(scan_.spacing.worst_at) +
                      "); --surface smooth closes the surface between the points, a "
                      "denser scan or a larger tool sinks less, --accept-sparse goes "
                      "on as it is");
    clean_ = part_;
    clean_points_ = points_;
    // Few points can only be smoothed over more ground than the tool's end covers, and
    // its form would go with their noise; nor do they hold the tool up on their peaks.
    const double fewest = std::sqrt(kFewestNeighbours / M_PI) * scan_.spacing.median;
    const bool dense = fewest <= last.tipRadius();
    figures_.noise_kept = noisy && !dense && options_.surface == SurfaceChoice::Auto;
    if (!figures_.smooth || !noisy || figures_.noise_kept)
      return;
    const double ratio = figures_.noise / (kNoiseLeft * options_.tolerance);
    const WorkStep step({kNoiseShare, 1.0});
    PointSmoother<pcl::PointXYZ> smoother;
    smoother.setNoise(figures_.noise);
    smoother.setMostRaised(kMostRaised * options_.tolerance);
    smoother.setNeighbours(static_cast<int>(
        std::clamp(4 * ratio * ratio, kFewestNeighbours, kMostNeighbours)));
    smoother.setNumberOfThreads(options_.threads);
    smoother.setInputCloud(part_);
    clean_.reset(new pcl::PointCloud<pcl::PointXYZ>);
    smoother.filter(*clean_);
    clean_points_ = std::make_shared<PointIndex>(indexOf(*clean_));
    figures_.farthest = smoother.getFarthest();
    figures_.smoothing = smoother.getReport();
    figures_.noise_left = figures_.smoothing.get("noise_left_mm");
  });
}

void MillJob::makeMap()
{
  timed("map", [&] {
    const double void_between = std::max(scan_.spacing.median, 1e-3);
    const Tool& rough = options_.rough.tool;
    double cell = options_.cell; // no wider than the default step-over
    if (cell <= 0)
      cell = std::min(rough.diameter / 20, rough.endDiameter() * kRoughStepOver);
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
    occupancy.setThroughHoles(options_.through_holes);
    occupancy.setInputCloud(clean_);
    map_.reset(new CellCloud);
    occupancy.filter(*map_);
    gaps_ = occupancy.getGaps();

    // Between points as well; over gaps, and over such voids between points that the
    // finest tool might fall into.
    CellCloud bridges, across;
    const auto to_points = distanceToPoints(*map_);
    const double wide = kWideVoid * options_.finish.tool.tipRadius();
    for (std::size_t i = 0; i < map_->size(); ++i) {
      const PointCell& c = (*map_)[i];
      if (c.getState() == CellState::Between || c.getState() == CellState::Gap)
        bridges.push_back(c);
      if (c.getState() == CellState::Gap ||
          (c.getState() == CellState::Between && to_points[i] * cell >= wide))
        across.push_back(c);
    }
    const auto with = [&](const CellCloud& fill) {
      return fill.empty() ? clean_points_
                          : std::make_shared<PointIndex>(indexOf(*clean_, fill));
    };
    surface_ = with(bridges);
    // Between points, quadrics close the surface better than level cells.
    const CellCloud& kept = figures_.smooth ? across : bridges;
    bridges_ = kept.empty() ? nullptr : std::make_shared<PointIndex>(indexOf(kept));
    if (figures_.smooth) {
      SmoothSurface smooth;
      smooth.fidelity = kFidelity * options_.tolerance;
      model_ = std::make_shared<SurfaceModel>(with(across), smooth);
    }
    else
      model_ = std::make_shared<SurfaceModel>(surface_);

    bridged_area_ = occupancy.getReport().get("between_points_mm2");
  });
}

} // namespace pointmill
