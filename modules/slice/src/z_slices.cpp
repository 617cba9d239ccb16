// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/z_slices.h>

#include <cmath>

namespace pointmill {

std::vector<double> ZSlices::levels() const
{
  validateParameters(*this, "ZSlices");
  const double depth = z_max_ - z_min_;
  checkRange("ZSlices", "depth (z_max - z_min)", depth, "mm", {1e-3, 10000});
  // A depth of exactly n pitches must not round up to n + 1.
  const double count = std::ceil(depth / pitch_ - 1e-9);
  checkRange("ZSlices", "number of levels", count, "", {1, 100000});
  std::vector<double> levels;
  for (int k = 1; k < count; ++k)
    levels.push_back(z_max_ - k * pitch_);
  levels.push_back(z_min_);
  return levels;
}

} // namespace pointmill
