// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/sorted_points.h>

#include <functional>

namespace pointmill {

/// Sorts points into cells: once through the input for its box, once to count the
/// points of each band of rows, once to deal them to the bands, and then band by band
/// in the cache. The order does not depend on the number of threads.
class CellSort {
public:
  /// Bands hold whole multiples of 2^this rows.
  static constexpr int kRowsTogetherShift = 2;

  /// Measures the box, so that `points().frame` is known. Points that are not finite
  /// are left out.
  /// @throws DataError for no finite point, or more than 4294967295
  CellSort(std::vector<PointSource> sources, unsigned threads);

  /// How many points were not finite.
  std::size_t dropped() const { return dropped_; }
  const SortedPoints& points() const { return points_; }

  /// Sorts, and calls @p sorted(row0, row1) for the rows of each band as soon as they
  /// are in order, from several threads.
  SortedPoints run(const std::function<void(int, int)>& sorted);

private:
  struct Part; // of the input

  void measure();
  void chooseCells();
  void chooseBands();
  void countBands();
  void deal();
  void sortBand(std::size_t band, struct BandScratch& scratch);
  template <typename Visit>
  void forPoints(std::size_t part, Visit&& visit) const;
  int bandOf(float y) const { return points_.frame.row(y) >> band_shift_; }

  std::vector<PointSource> sources_;
  unsigned threads_;
  std::size_t count_ = 0, parts_ = 1, dropped_ = 0, finite_ = 0;
  int band_shift_ = kRowsTogetherShift, bands_ = 1;
  std::vector<std::size_t> at_; // [part][band]: where its next point goes
  std::vector<std::size_t> band_start_;
  SortedPoints points_;
};

} // namespace pointmill
