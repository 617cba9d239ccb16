// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "row.h"
#include "scallop_tally.h"

#include <vector>

namespace pointmill {

/// A station at which the rows cannot hold the scallop.
struct Steep {
  Eigen::Vector2d xy;
  double height, weight; ///< of the scallop; see ScallopTally
};

/// What was found and done between two regular rows.
struct Insertion {
  std::vector<Pass> passes;
  ScallopTally tally; ///< where the scallop holds
  std::vector<Steep> steep;
  double kept_out = 0; ///< length of rows that keep-out zones take [mm]
};

/// Inserts parts of rows halfway between two rows where the scallop between them would
/// be too high, and goes on so between these, until it is not or rows would come nearer
/// to each other than the least step-over.
class RowInserter {
public:
  /// @param noise of the sagittas, see roughness()
  RowInserter(const RowMaker& rows, const Raster& raster, double noise)
      : rows_(rows), raster_(raster), noise_(noise)
  {
  }

  /// Between @p low and @p high, which both cover @p stretches.
  Insertion
  between(const Row& low, const Row& high, const std::vector<Stretch>& stretches) const;

private:
  void insert(const Row& low,
              const Row& high,
              Stretch stretch,
              double weight,
              Insertion& result) const;
  std::vector<Stretch> parts(const std::vector<char>& wanted, Stretch whole) const;

  const RowMaker& rows_;
  const Raster& raster_;
  double noise_;
};

} // namespace pointmill
