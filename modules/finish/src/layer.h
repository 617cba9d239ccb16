// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "mask.h"
#include "row_inserter.h"

#include <vector>

namespace pointmill {

/// All that rows of one direction give.
struct Layer {
  std::vector<Pass> passes; ///< in the sense of u, by v and then by u
  std::size_t inserted = 0; ///< of these, between the regular rows
  double kept_out = 0;      ///< length of rows that keep-out zones take [mm]
  ScallopTally tally;
  std::vector<Steep> steep;
  double noise = 0; ///< of the sagittas, see roughness()
};

/// Lays rows of one direction.
class LayerMaker {
public:
  LayerMaker(const SurfaceModel& surface, const Raster& raster, double degrees);

  Layer everywhere() const;
  /// @param noise as another layer has found it: here the rows may be short
  Layer on(const Mask& mask, double noise) const;

private:
  using Stretches = std::vector<Stretch>; // of one row

  bool empty() const { return rows_.width().first > rows_.width().last; }
  Stretches stretchesOn(const Mask& mask, std::size_t row) const;
  std::vector<Row> dropRows(const std::vector<Stretches>& stretches) const;
  double measureNoise(const std::vector<Row>& rows) const;
  Layer make(const std::vector<Stretches>& stretches, const double* noise) const;

  const Raster& raster_;
  RowMaker rows_;
  Places places_;
};

} // namespace pointmill
