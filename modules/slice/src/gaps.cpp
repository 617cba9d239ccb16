// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/gaps.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using Mask = std::vector<unsigned char>;

/// Calls visit(column, row) for the four neighbours of a cell that the grid has.
template <typename Visit>
void neighbours(const CellGrid& grid, int column, int row, Visit&& visit)
{
  constexpr int step[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (const auto& s : step)
    if (grid.has(column + s[0], row + s[1]))
      visit(column + s[0], row + s[1]);
}

/// All cells of `mask` that are connected to (column, row); they are taken out of it.
std::vector<std::size_t>
takeRegion(const CellGrid& grid, Mask& mask, int column, int row)
{
  std::vector<std::size_t> region{grid.index(column, row)};
  mask[region.front()] = 0;
  for (std::size_t k = 0; k < region.size(); ++k)
    neighbours(grid,
               static_cast<int>(region[k] % grid.columns),
               static_cast<int>(region[k] / grid.columns),
               [&](int c, int r) {
                 const std::size_t at = grid.index(c, r);
                 if (mask[at]) {
                   mask[at] = 0;
                   region.push_back(at);
                 }
               });
  return region;
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
  takeRegion(wide, open, 0, 0); // what is connected to the border lies outside

  Mask gaps(grid.size(), 0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t at = wide.index(column + pad, row + pad);
      const bool inside = open[at] || to_away[at] > cells;
      gaps[grid.index(column, row)] = inside && !body[at];
    }
  return gaps;
}

std::vector<GapRegion>
gapRegions(const CellGrid& grid, const Mask& occupied, const Mask& gaps, double reach)
{
  const auto distance = distanceField(occupied, grid.columns, grid.rows);
  std::vector<GapRegion> regions;
  Mask left = gaps;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!left[grid.index(column, row)])
        continue;
      GapRegion region;
      const auto cells = takeRegion(grid, left, column, row);
      region.min.setConstant(std::numeric_limits<double>::infinity());
      region.max = -region.min;
      double widest = 0;
      for (const auto at : cells) {
        const Eigen::Vector2d p(grid.x(static_cast<int>(at % grid.columns)),
                                grid.y(static_cast<int>(at / grid.columns)));
        region.centre += p / static_cast<double>(cells.size());
        region.min = region.min.cwiseMin((p.array() - grid.cell / 2).matrix());
        region.max = region.max.cwiseMax((p.array() + grid.cell / 2).matrix());
        widest = std::max<double>(widest, distance[at] * grid.cell);
      }
      region.area = static_cast<double>(cells.size()) * grid.cell * grid.cell;
      region.between_points = widest <= reach;
      regions.push_back(region);
    }
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return regions;
}

void bridgeGaps(const CellGrid& grid, const Mask& gaps, std::vector<double>& height)
{
  std::vector<int> unknown(grid.size(), -1);
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (gaps[i]) {
      unknown[i] = static_cast<int>(cells.size());
      cells.push_back(i);
    }
  if (cells.empty())
    return;
  // A cell is the mean of its neighbours; those outside the outline do not count.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cells.size()));
  for (std::size_t k = 0; k < cells.size(); ++k) {
    double count = 0;
    neighbours(grid,
               static_cast<int>(cells[k] % grid.columns),
               static_cast<int>(cells[k] / grid.columns),
               [&](int c, int r) {
                 const std::size_t at = grid.index(c, r);
                 if (unknown[at] >= 0)
                   entries.emplace_back(static_cast<int>(k), unknown[at], -1.0);
                 else if (std::isfinite(height[at]))
                   right[static_cast<Eigen::Index>(k)] += height[at];
                 else
                   return;
                 ++count;
               });
    entries.emplace_back(static_cast<int>(k), static_cast<int>(k), count);
  }
  const auto n = static_cast<Eigen::Index>(cells.size());
  Eigen::SparseMatrix<double> laplace(n, n);
  laplace.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplace);
  const Eigen::VectorXd solution = solver.solve(right);
  if (solver.info() != Eigen::Success || !solution.allFinite())
    throw DataError("the gaps of the scan cannot be bridged: a gap touches no point");
  for (std::size_t k = 0; k < cells.size(); ++k)
    height[cells[k]] = solution[static_cast<Eigen::Index>(k)];
}

} // namespace pointmill
