// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/cell_regions.h>
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/gaps.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

namespace pointmill {
namespace {

using Mask = std::vector<unsigned char>;

/// What surrounds the region's cells: heights, or nothing.
void measureRim(const CellGrid& grid,
                const Mask& gaps,
                const std::vector<double>& height,
                GapRegion& region)
{
  for (const auto cell : region.cells) {
    int known = 0;
    forNeighbours(grid,
                  static_cast<int>(cell % grid.columns),
                  static_cast<int>(cell / grid.columns),
                  [&](int c, int r, bool) {
                    const std::size_t at = grid.index(c, r);
                    known += gaps[at] || std::isfinite(height[at]);
                    if (gaps[at] || !std::isfinite(height[at]))
                      return;
                    region.rim_low = std::fmin(region.rim_low, height[at]);
                    region.rim_high = std::fmax(region.rim_high, height[at]);
                  });
    region.open |= known < 8;
  }
}

std::string noGapAt(const Eigen::Vector2d& place,
                    const std::vector<GapRegion>& regions,
                    std::size_t nearest,
                    double distance)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "no gap of the scan lies at the through hole X" << place.x() << " Y"
       << place.y() << ": ";
  if (regions.empty())
    text << "the scan has none (one narrower than twice the gap reach is none)";
  else
    text << "the nearest, of " << regions[nearest].area << " mm2 about X"
         << regions[nearest].centre.x() << " Y" << regions[nearest].centre.y()
         << ", begins " << distance << " mm away";
  return text.str();
}

} // namespace

std::vector<unsigned char>
findGaps(const CellGrid& grid, const Mask& occupied, double reach)
{
  // One empty ring and room for the dilation, so that closing sees no border.
  const double cells = reach / grid.cell;
  const int pad = static_cast<int>(std::ceil(cells)) + 2;
  CellGrid wide = grid;
  wide.columns += 2 * pad;
  wide.rows += 2 * pad;
  Mask body(wide.size(), 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      body[wide.index(column + pad, row + pad)] = occupied[grid.index(column, row)];

  const auto to_body = distanceField(body, wide.columns, wide.rows);
  Mask away(wide.size());
  for (std::size_t i = 0; i < away.size(); ++i)
    away[i] = to_body[i] > cells;
  const auto to_away = distanceField(away, wide.columns, wide.rows);
  Mask open(wide.size()); // neither occupied nor closed
  for (std::size_t i = 0; i < open.size(); ++i)
    open[i] = !body[i] && to_away[i] <= cells;
  std::vector<std::size_t> outside{0}; // what is connected to the border
  takeRegion(wide, open, Connected::Edges, outside);

  Mask gaps(grid.size(), 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t at = wide.index(column + pad, row + pad);
      const bool inside = open[at] || to_away[at] > cells;
      gaps[grid.index(column, row)] = inside && !body[at];
    }
  // On a grid, closing may leave a cell by itself that no point is next to: no gap.
  Mask left = gaps;
  std::vector<std::size_t> held;
  for (std::size_t at = 0; at < grid.size(); ++at)
    if (occupied[at])
      held.push_back(at);
  takeRegion(grid, left, Connected::Corners, held);
  for (std::size_t at = 0; at < grid.size(); ++at)
    gaps[at] = gaps[at] && !left[at];
  return gaps;
}

std::vector<unsigned char>
wideGaps(const CellGrid& grid, const Mask& occupied, const Mask& gaps, double reach)
{
  const auto to_point = distanceField(occupied, grid.columns, grid.rows);
  Mask core(grid.size());
  for (std::size_t at = 0; at < grid.size(); ++at)
    core[at] = gaps[at] && to_point[at] * grid.cell > reach;
  const auto to_core = distanceField(core, grid.columns, grid.rows);
  Mask wide(grid.size());
  for (std::size_t at = 0; at < grid.size(); ++at)
    wide[at] = gaps[at] && to_core[at] * grid.cell <= reach;
  return wide;
}

std::vector<GapRegion>
gapRegions(const CellGrid& grid, const Mask& gaps, const std::vector<double>& height)
{
  std::vector<GapRegion> regions;
  Mask left = gaps;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!left[grid.index(column, row)])
        continue;
      GapRegion region;
      std::vector<std::size_t> cells{grid.index(column, row)};
      takeRegion(grid, left, Connected::Corners, cells);
      region.min.setConstant(std::numeric_limits<double>::infinity());
      region.max = -region.min;
      for (const auto at : cells) {
        const Eigen::Vector2d p(grid.x(static_cast<int>(at % grid.columns)),
                                grid.y(static_cast<int>(at / grid.columns)));
        region.centre += p / static_cast<double>(cells.size());
        region.min = region.min.cwiseMin((p.array() - grid.cell / 2).matrix());
        region.max = region.max.cwiseMax((p.array() + grid.cell / 2).matrix());
      }
      region.area = static_cast<double>(cells.size()) * grid.cell * grid.cell;
      region.cells = std::move(cells);
      measureRim(grid, gaps, height, region);
      regions.push_back(std::move(region));
    }
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return regions;
}

void nameThroughHoles(const CellGrid& grid,
                      const std::vector<Eigen::Vector2d>& places,
                      std::vector<GapRegion>& regions)
{
  std::vector<std::size_t> named;
  for (const auto& place : places) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t which = 0;
    for (std::size_t i = 0; i < regions.size(); ++i)
      for (const auto cell : regions[i].cells) {
        const Eigen::Vector2d centre(grid.x(static_cast<int>(cell % grid.columns)),
                                     grid.y(static_cast<int>(cell / grid.columns)));
        // To the square cell, 0 inside.
        const Eigen::Array2d beside = (place - centre).array().abs() - grid.cell / 2;
        const double distance = beside.max(0.0).matrix().norm();
        if (distance < nearest) {
          nearest = distance;
          which = i;
        }
      }
    // Neither a point's rounding to float nor that of the grid makes a place miss.
    if (!(nearest <= 1e-6 * grid.cell))
      throw ParameterError(noGapAt(place, regions, which, nearest));
    named.push_back(which);
  }
  for (const auto which : named) {
    regions[which].kind = GapKind::ThroughHole;
    regions[which].treatment = GapPolicy::Mill;
  }
}

void bridgeGaps(const CellGrid& grid, const Mask& gaps, std::vector<double>& height)
{
  const auto regions = gapRegions(grid, gaps, height);
  for (const auto& region : regions)
    if (std::isnan(region.rim_low))
      throw DataError("the gaps of the scan cannot be bridged: a gap touches no point");
  std::vector<int> unknown(grid.size(), -1);
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (gaps[i]) {
      unknown[i] = static_cast<int>(cells.size());
      cells.push_back(i);
    }
  if (cells.empty())
    return;
  // A cell is the mean of its neighbours, diagonal ones at half weight; those outside
  // the outline do not count.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cells.size()));
  for (std::size_t k = 0; k < cells.size(); ++k) {
    double count = 0;
    forNeighbours(grid,
                  static_cast<int>(cells[k] % grid.columns),
                  static_cast<int>(cells[k] / grid.columns),
                  [&](int c, int r, bool straight) {
                    const std::size_t at = grid.index(c, r);
                    const double weight = straight ? 1.0 : 0.5;
                    if (unknown[at] >= 0)
                      entries.emplace_back(static_cast<int>(k), unknown[at], -weight);
                    else if (std::isfinite(height[at]))
                      right[static_cast<Eigen::Index>(k)] += weight * height[at];
                    else
                      return;
                    count += weight;
                  });
    entries.emplace_back(static_cast<int>(k), static_cast<int>(k), count);
  }
  const auto n = static_cast<Eigen::Index>(cells.size());
  Eigen::SparseMatrix<double> laplace(n, n);
  laplace.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplace);
  const Eigen::VectorXd solution = solver.solve(right);
  if (solver.info() != Eigen::Success || !solution.allFinite())
    throw DataError("the gaps of the scan cannot be bridged: their equations have no "
                    "solution");
  for (std::size_t k = 0; k < cells.size(); ++k)
    height[cells[k]] = solution[static_cast<Eigen::Index>(k)];
  // The solution keeps within its rim but for rounding.
  for (const auto& region : regions)
    for (const auto at : region.cells)
      height[at] = std::clamp(height[at], region.rim_low, region.rim_high);
}

} // namespace pointmill
