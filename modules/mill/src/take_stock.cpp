// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the part is milled from: a block, or the scan of a raw part.
#include <pointmill/io/raw_scan.h>
#include <pointmill/io/scan.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/slice/cell_grid.h>
#include <pointmill/surface/raw_stock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pointmill {
namespace {

/// The part may stick out of the scan of its raw part at this share of its points, and
/// by so much, for what both scanners err [mm].
constexpr double kMostOutside = 0.02, kOutside = 0.5;

std::string corner(const Eigen::Vector3d& p)
{
  char text[80];
  std::snprintf(text, sizeof text, "X%.3f Y%.3f Z%.3f", p.x(), p.y(), p.z());
  return text;
}

} // namespace

void MillJob::readRawStock()
{
  const RawScan raw = readScan(options_.stock_scan);
  // Samples as dense as the part's points lie.
  const double spacing = std::max(scan_.spacing.median, 0.05);
  const Scan scan = prepareScan(
      raw, {scan_.scale, 0.0}, 1.0 / (spacing * spacing), kMostSamples, options_.seed);
  pcl::PointCloud<pcl::PointXYZ> cloud = *scan.cloud;
  for (auto& p : cloud) {
    const Eigen::Vector3d at = p.getVector3fMap().cast<double>() + scan.shift;
    const Eigen::Vector3d in_part = (alignment_ * at.homogeneous()).head<3>();
    p.getVector3fMap() = in_part.cast<float>();
  }
  // Twice what lies between two points, and more than a cell.
  raw_reach_ = std::max(2 * measureSpacing(cloud, options_.seed).p99,
                        2 * CellGrid::of(*map_).cell);
  raw_ = std::make_shared<PointIndex>(std::vector<PointSource>{pointSource(cloud)},
                                      options_.threads);
}

void MillJob::makeStock()
{
  const double margin = options_.stock_margin;
  stock_.min = points_->min() - Eigen::Vector3d(margin, margin, options_.stock_bottom);
  stock_.max = points_->max() + Eigen::Vector3d(margin, margin, options_.stock_top);
  if (options_.stock_box)
    stock_ = *options_.stock_box;
  raw_ = nullptr;
  if (!options_.stock_scan.empty()) {
    readRawStock();
    stock_.min.head<2>() = raw_->min().head<2>();
    stock_.min.z() = std::min(raw_->min().z(), stock_.min.z());
    stock_.max = raw_->max();
  }
  for (int i = 0; i < 3; ++i)
    if (points_->min()[i] < stock_.min[i] - kOutside ||
        points_->max()[i] > stock_.max[i] + kOutside)
      throw DataError("the part, " + corner(points_->min()) + " to " +
                      corner(points_->max()) + ", is not within its stock, " +
                      corner(stock_.min) + " to " + corner(stock_.max));
  floor_ = std::isnan(options_.floor)
               ? std::max(clean_points_->min().z(), stock_.min.z())
               : options_.floor;
  if (floor_ < stock_.min.z() - 1e-6)
    throw ParameterError("mill: --floor lies below the stock's bottom, Z" +
                         std::to_string(stock_.min.z()));
  if (stock_.max.z() - floor_ < 1e-3)
    throw DataError("the part is flat: there is nothing to mill");
  const double cell = CellGrid::of(*map_).cell;
  const auto field = [&](double size, StockField::Bound bound) {
    return std::make_shared<StockField>(
        raw_ ? stockOf(stock_, size, bound, *raw_, raw_reach_)
             : StockField(stock_, size, bound));
  };
  standing_ = field(cell, StockField::Bound::Upper);
  nominal_ = field(cell / 2, StockField::Bound::Nominal);
  if (!raw_)
    return;
  std::size_t outside = 0;
  for (const auto& p : *part_)
    outside += p.z > standing_->highest(p.x, p.y, 0) + kOutside;
  if (double(outside) > kMostOutside * double(part_->size()))
    throw DataError(options_.stock_scan + ": " + std::to_string(outside) +
                    " points of the part lie above its raw part: the two scans are not "
                    "in one frame");
}

} // namespace pointmill
