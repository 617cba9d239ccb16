// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "point_buckets.h"

#include <pointmill/common/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pointmill {
namespace {

constexpr double kPerCell = 1.5;      // points in a cell that has any
constexpr double kPerCoarseCell = 16; // when it is found out how much they cover
constexpr double kCellsPerPoint = 4;  // at most, where they cover little of their box
constexpr double kMostCells = 64e6;
constexpr int kBlocks = 256, kChunks = 32;

} // namespace

PlanBox::PlanBox(const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector2f min = points.front().head<2>(), max = min;
  for (const auto& p : points) {
    min = min.cwiseMin(p.head<2>());
    max = max.cwiseMax(p.head<2>());
  }
  low = min.cast<double>();
  high = max.cast<double>();
}

CellGrid PointBuckets::naturalGrid(const Points& points)
{
  const auto [low, high] = PlanBox(points);
  const Eigen::Vector2d size = high - low;
  const auto n = static_cast<double>(points.size());
  // Points on a line along an axis cover a strip as wide as they are apart.
  const double longest = std::max(size.maxCoeff(), 1e-6);
  const double area = size.cwiseMax(longest / n).prod();
  const CellGrid coarse =
      CellGrid::covering(low, high, std::sqrt(kPerCoarseCell * area / n));
  std::vector<unsigned char> held(coarse.size(), 0);
  for (const auto& p : points)
    held[coarse.index(coarse.columnOf(p.x()), coarse.rowOf(p.y()))] = 1;
  const auto covered = static_cast<double>(std::count(held.begin(), held.end(), 1)) *
                       coarse.cell * coarse.cell;
  const double cell_area = kPerCell * std::min(covered, area) / n;
  const double least = area / std::min(kCellsPerPoint * n, kMostCells);
  return CellGrid::covering(low, high, std::sqrt(std::max(cell_area, least)));
}

PointBuckets::PointBuckets(Points points, const CellGrid& grid)
    : grid_(grid), per_mm_(1 / grid.cell), points_(std::move(points)),
      start_(grid.size() + 1)
{
  // In two steps, each of which writes to few places at a time: into blocks of rows, by
  // chunks of the input, and within each block into cells. Both keep the input's order.
  const std::size_t n = points_.size();
  const int block_rows = (grid_.rows + kBlocks - 1) / kBlocks;
  const auto chunk = [&](std::size_t i) { return i * n / kChunks; };
  Points blocks(n);
  std::vector<std::array<std::size_t, kBlocks>> next(kChunks);
  parallelFor(kChunks, 0, [&](std::size_t c) {
    next[c].fill(0);
    for (std::size_t i = chunk(c); i < chunk(c + 1); ++i)
      ++next[c][rowOf(points_[i]) / block_rows];
  });
  std::array<std::size_t, kBlocks + 1> begin;
  std::size_t sum = 0;
  for (int b = 0; b < kBlocks; ++b) {
    begin[b] = sum;
    for (auto& of_chunk : next)
      sum += std::exchange(of_chunk[b], sum);
  }
  begin[kBlocks] = sum;
  parallelFor(kChunks, 0, [&](std::size_t c) {
    for (std::size_t i = chunk(c); i < chunk(c + 1); ++i)
      blocks[next[c][rowOf(points_[i]) / block_rows]++] = points_[i];
  });
  parallelFor(kBlocks, 0, [&](std::size_t b) {
    const int row0 = static_cast<int>(b) * block_rows;
    const int row1 = std::min(grid_.rows, row0 + block_rows);
    if (row0 >= row1)
      return;
    const auto cellOf = [&](const Eigen::Vector3f& p) {
      return grid_.index(columnOf(p), rowOf(p) - row0);
    };
    std::vector<std::uint32_t> at(grid_.index(0, row1 - row0), 0);
    for (std::size_t i = begin[b]; i < begin[b + 1]; ++i)
      ++at[cellOf(blocks[i])];
    auto first = static_cast<std::uint32_t>(begin[b]);
    for (std::size_t i = 0; i < at.size(); ++i) {
      start_[grid_.index(0, row0) + i] = first;
      first += std::exchange(at[i], first);
    }
    for (std::size_t i = begin[b]; i < begin[b + 1]; ++i)
      points_[at[cellOf(blocks[i])]++] = blocks[i];
  });
  start_.back() = static_cast<std::uint32_t>(n);
}

std::size_t PointBuckets::count(int row, int column0, int column1) const
{
  column0 = std::max(column0, 0);
  column1 = std::min(column1, grid_.columns - 1);
  if (row < 0 || row >= grid_.rows || column0 > column1)
    return 0;
  return start_[grid_.index(column1, row) + 1] - start_[grid_.index(column0, row)];
}

double PointBuckets::distance(double x, double y, double most) const
{
  double least = most * most;
  walk(
      x,
      y,
      [&](double reached) { return reached <= 0 || reached * reached < least; },
      [&](const Eigen::Vector3f& p, std::uint32_t) {
        const double dx = p.x() - x, dy = p.y() - y;
        least = std::min(least, dx * dx + dy * dy);
      });
  return least < most * most ? std::sqrt(least)
                             : std::numeric_limits<double>::infinity();
}

void PointBuckets::nearest(const Eigen::Vector3f& place,
                           std::size_t k,
                           std::vector<Neighbour>& heap) const
{
  heap.clear();
  walk(
      place.x(),
      place.y(),
      [&](double reached) {
        return heap.size() < k || reached <= 0 ||
               reached * reached <= heap.front().squared;
      },
      [&](const Eigen::Vector3f& p, std::uint32_t number) {
        const Neighbour next{(p - place).squaredNorm(), number};
        if (heap.size() < k) {
          heap.push_back(next);
          std::push_heap(heap.begin(), heap.end());
        }
        else if (next < heap.front()) {
          std::pop_heap(heap.begin(), heap.end());
          heap.back() = next;
          std::push_heap(heap.begin(), heap.end());
        }
      });
  std::sort_heap(heap.begin(), heap.end());
}

} // namespace pointmill
