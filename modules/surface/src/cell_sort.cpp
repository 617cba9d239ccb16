// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cell_sort.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

namespace pointmill {
namespace {

/// Cells hold about this many points: few enough to skip most, enough to be worth a
/// look.
constexpr double kPointsPerCell = 6.0;
constexpr double kMostCells = 64e6;
/// A band and its copy shall fit into a core's cache; too many bands would not.
constexpr double kPointsPerBand = 16e3;
constexpr int kMostBands = 2048;

float infinity()
{
  return std::numeric_limits<float>::infinity();
}

/// Lower and upper corner of points, and their number.
struct Box {
  float low[3] = {infinity(), infinity(), infinity()};
  float high[3] = {-infinity(), -infinity(), -infinity()};
  std::size_t count = 0;

  void add(float x, float y, float z)
  {
    const float p[3] = {x, y, z};
    for (int k = 0; k < 3; ++k) {
      low[k] = p[k] < low[k] ? p[k] : low[k];
      high[k] = p[k] > high[k] ? p[k] : high[k];
    }
    ++count;
  }
  void add(const Box& other)
  {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
    count += other.count;
  }
};

/// Zero for finite numbers, else NaN.
bool allFinite(float x, float y, float z)
{
  return x * 0.f + y * 0.f + z * 0.f == 0.f;
}

} // namespace

/// What the sorting of one band needs, kept from band to band.
struct BandScratch {
  std::vector<std::uint32_t> cell, next;
  std::vector<float> column;
};

CellSort::CellSort(std::vector<PointSource> sources, unsigned threads)
    : sources_(std::move(sources)),
      threads_(threads ? threads : std::max(1u, std::thread::hardware_concurrency()))
{
  for (const auto& s : sources_)
    count_ += s.count;
  // Several parts for each thread, so that none waits long for another.
  parts_ = std::clamp<std::size_t>(count_ / 65536, 1, 8 * threads_);
  measure();
  chooseCells();
  chooseBands();
}

// Calls visit(x, y, z) for the finite points of the part in the order of the input.
template <typename Visit>
void CellSort::forPoints(std::size_t part, Visit&& visit) const
{
  std::size_t first = count_ * part / parts_, last = count_ * (part + 1) / parts_;
  for (const auto& s : sources_) {
    const std::size_t begin = std::min(first, s.count), end = std::min(last, s.count);
    const auto each = [&](auto at) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t k = at(i) * s.stride;
        const float x = s.xyz[0][k], y = s.xyz[1][k], z = s.xyz[2][k];
        if (allFinite(x, y, z))
          visit(x, y, z);
      }
    };
    if (s.indices)
      each([&](std::size_t i) { return static_cast<std::size_t>(s.indices[i]); });
    else
      each([](std::size_t i) { return i; });
    first -= begin;
    last -= end;
  }
}

void CellSort::measure()
{
  std::vector<Box> boxes(parts_);
  parallelFor(parts_, threads_, [&](std::size_t part) {
    Box box;
    forPoints(part, [&](float x, float y, float z) { box.add(x, y, z); });
    boxes[part] = box;
  });
  Box all;
  for (const auto& box : boxes)
    all.add(box);
  finite_ = all.count;
  dropped_ = count_ - finite_;
  if (finite_ == 0)
    throw DataError("no finite point to cut: the cloud is empty");
  if (finite_ > std::numeric_limits<std::uint32_t>::max())
    throw DataError("more than 4294967295 points: thin the scan");
  points_.min = {all.low[0], all.low[1], all.low[2]};
  points_.max = {all.high[0], all.high[1], all.high[2]};
}

void CellSort::chooseCells()
{
  const Eigen::Vector3d size = points_.max - points_.min;
  const double longest = std::max({size.x(), size.y(), 1e-3});
  const double cells =
      std::clamp(static_cast<double>(finite_) / kPointsPerCell, 1.0, kMostCells);
  CellFrame& frame = points_.frame;
  frame.x0 = points_.min.x();
  frame.y0 = points_.min.y();
  // A thin strip has little area; the second bound keeps its rows and columns
  // countable.
  frame.cell = std::max(std::sqrt(size.x() * size.y() / cells), longest / cells);
  frame.per_mm = 1 / frame.cell;
  frame.columns = static_cast<int>(size.x() * frame.per_mm) + 1;
  frame.rows = static_cast<int>(size.y() * frame.per_mm) + 1;
}

void CellSort::chooseBands()
{
  const int rows = points_.frame.rows;
  const double wanted =
      std::clamp(static_cast<double>(finite_) / kPointsPerBand, 1.0, 1.0 * kMostBands);
  while ((1 << band_shift_) * wanted < rows)
    ++band_shift_;
  bands_ = ((rows - 1) >> band_shift_) + 1;
}

SortedPoints CellSort::run(const std::function<void(int, int)>& sorted)
{
  for (auto* column : {&points_.x, &points_.y, &points_.z}) {
    column->resize(finite_ + SortedPoints::kPad);
    std::fill(column->end() - SortedPoints::kPad, column->end(), -infinity());
  }
  const CellFrame& frame = points_.frame;
  points_.start.resize(static_cast<std::size_t>(frame.columns) * frame.rows + 1);
  countBands();
  for (int band = 0; band < bands_; ++band)
    points_.start[(static_cast<std::size_t>(band) << band_shift_) * frame.columns] =
        static_cast<std::uint32_t>(band_start_[band]);
  points_.start.back() = static_cast<std::uint32_t>(finite_);
  deal();
  std::atomic<std::size_t> next{0};
  parallelFor(threads_, threads_, [&](std::size_t) {
    BandScratch scratch;
    for (std::size_t band; (band = next++) < static_cast<std::size_t>(bands_);) {
      sortBand(band, scratch);
      const int row0 = static_cast<int>(band << band_shift_);
      sorted(row0, std::min(row0 + (1 << band_shift_), frame.rows));
    }
  });
  return std::move(points_);
}

void CellSort::countBands()
{
  at_.assign(parts_ * bands_, 0);
  parallelFor(parts_, threads_, [&](std::size_t part) {
    std::size_t* count = &at_[part * bands_];
    forPoints(part, [&](float, float y, float) { ++count[bandOf(y)]; });
  });
  // All points of a band together, and in it those of the first part first.
  band_start_.assign(1, 0);
  std::size_t sum = 0;
  for (int band = 0; band < bands_; ++band) {
    for (std::size_t part = 0; part < parts_; ++part)
      sum += std::exchange(at_[part * bands_ + band], sum);
    band_start_.push_back(sum);
  }
}

void CellSort::deal()
{
  parallelFor(parts_, threads_, [&](std::size_t part) {
    std::size_t* at = &at_[part * bands_];
    forPoints(part, [&](float x, float y, float z) {
      const std::size_t to = at[bandOf(y)]++;
      points_.x[to] = x;
      points_.y[to] = y;
      points_.z[to] = z;
    });
  });
}

void CellSort::sortBand(std::size_t band, BandScratch& scratch)
{
  const CellFrame& frame = points_.frame;
  const int row0 = static_cast<int>(band << band_shift_);
  const int row1 = std::min(row0 + (1 << band_shift_), frame.rows);
  const std::size_t first_cell = static_cast<std::size_t>(row0) * frame.columns;
  const std::size_t cells = static_cast<std::size_t>(row1 - row0) * frame.columns;
  const std::size_t first = band_start_[band], count = band_start_[band + 1] - first;
  const float *x = &points_.x[first], *y = &points_.y[first];

  scratch.cell.resize(std::max(scratch.cell.size(), count));
  scratch.column.resize(std::max(scratch.column.size(), count));
  scratch.next.assign(cells, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t cell =
        static_cast<std::size_t>(frame.row(y[i]) - row0) * frame.columns +
        frame.column(x[i]);
    scratch.cell[i] = static_cast<std::uint32_t>(cell);
    ++scratch.next[cell];
  }
  // Where a band starts is known already; the band before reads it.
  std::uint32_t sum = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (cell > 0)
      points_.start[first_cell + cell] = static_cast<std::uint32_t>(first) + sum;
    sum += std::exchange(scratch.next[cell], sum);
  }
  // From here on `cell` holds the place of each point.
  for (std::size_t i = 0; i < count; ++i)
    scratch.cell[i] = scratch.next[scratch.cell[i]]++;
  for (auto* column : {&points_.x, &points_.y, &points_.z}) {
    float* values = column->data() + first;
    for (std::size_t i = 0; i < count; ++i)
      scratch.column[scratch.cell[i]] = values[i];
    std::memcpy(values, scratch.column.data(), count * sizeof(float));
  }
}

} // namespace pointmill
