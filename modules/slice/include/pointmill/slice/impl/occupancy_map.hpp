// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/occupancy_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {

template <typename PointT>
void OccupancyMap<PointT>::apply(CellCloud& output)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(this->indices_->size());
  Eigen::Vector3d low =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const auto i : *this->indices_) {
    const Eigen::Vector3f p = (*this->input_)[i].getVector3fMap();
    if (!p.allFinite())
      continue;
    points.push_back(p);
    low = low.cwiseMin(p.cast<double>());
    high = high.cwiseMax(p.cast<double>());
  }
  if (points.empty())
    throw DataError("OccupancyMap: no point of the input is finite");

  const CellGrid grid = CellGrid::covering(low.head<2>(), high.head<2>(), cell_size_);
  std::vector<double> height(grid.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::uint32_t> count(grid.size(), 0);
  for (const auto& p : points) {
    const std::size_t at = grid.index(std::min(grid.columnOf(p.x()), grid.columns - 1),
                                      std::min(grid.rowOf(p.y()), grid.rows - 1));
    if (count[at]++ == 0 || p.z() > height[at])
      height[at] = p.z();
  }

  std::vector<unsigned char> occupied(grid.size());
  for (std::size_t at = 0; at < grid.size(); ++at)
    occupied[at] = count[at] > 0;
  auto gap = findGaps(grid, occupied, gap_reach_);
  const auto wide = wideGaps(grid, occupied, gap, gap_reach_);
  auto between = gap;
  for (std::size_t at = 0; at < grid.size(); ++at)
    between[at] = gap[at] && !wide[at];
  fillBetweenPoints(grid, between, points, height);

  // What lies between points is part; only a real gap is for its treatment to decide.
  auto gaps = gapRegions(grid, wide, height);
  for (auto& region : gaps)
    region.treatment = policy_;
  nameThroughHoles(grid, through_holes_, gaps);
  std::vector<unsigned char> bridged(grid.size(), 0);
  const double highest = high.z();
  for (const auto& region : gaps)
    for (const auto at : region.cells) {
      bridged[at] = region.treatment == GapPolicy::Bridge;
      gap[at] = region.treatment != GapPolicy::Mill;
      if (region.treatment == GapPolicy::Keep)
        height[at] = highest;
    }
  bridgeGaps(grid, bridged, height);
  // Rounded up: no bridge becomes lower when it is stored.
  const auto stored = [](double z) {
    const auto rounded = static_cast<float>(z);
    return rounded < z ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                       : rounded;
  };

  output.resize(grid.size());
  output.width = static_cast<std::uint32_t>(grid.columns);
  output.height = static_cast<std::uint32_t>(grid.rows);
  output.is_dense = false;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t at = grid.index(column, row);
      PointCell& cell = output[at];
      cell.x = static_cast<float>(grid.x(column));
      cell.y = static_cast<float>(grid.y(row));
      cell.z = stored(height[at]);
      cell.count = count[at];
      cell.setState(occupied[at]  ? CellState::Occupied
                    : between[at] ? CellState::Between
                    : gap[at]     ? CellState::Gap
                                  : CellState::Empty);
    }

  gaps_ = std::move(gaps);
  double area = 0, hole_area = 0;
  std::size_t holes = 0;
  for (const auto& region : gaps_) {
    const bool hole = region.kind == GapKind::ThroughHole;
    holes += hole;
    (hole ? hole_area : area) += region.area;
  }
  const auto cells = [&](CellState state) {
    return static_cast<double>(
        std::count_if(output.begin(), output.end(), [&](const auto& c) {
          return c.getState() == state;
        }));
  };
  this->report_.set("points", static_cast<double>(points.size()));
  this->report_.set("nan_points",
                    static_cast<double>(this->indices_->size() - points.size()));
  this->report_.set("occupied_cells", cells(CellState::Occupied));
  this->report_.set("between_cells", cells(CellState::Between));
  this->report_.set("gap_cells", cells(CellState::Gap));
  this->report_.set("empty_cells", cells(CellState::Empty));
  this->report_.set("gaps", static_cast<double>(gaps_.size() - holes));
  this->report_.set("gap_area_mm2", area);
  this->report_.set("through_holes", static_cast<double>(holes));
  this->report_.set("through_hole_area_mm2", hole_area);
  this->report_.set("between_points_mm2",
                    static_cast<double>(std::count(between.begin(), between.end(), 1)) *
                        grid.cell * grid.cell);
}

} // namespace pointmill
