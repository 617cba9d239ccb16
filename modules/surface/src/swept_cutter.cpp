// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/swept_cutter.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

SweptCutter::SweptCutter(const CutterProfile& profile) : profile_(profile)
{
  // A hair wide of the rim, and of each step's inner end: rounding.
  constexpr double hair = 1e-9;
  const double area = std::max(1e-18, radius() * radius()) * (1 + hair);
  steps_per_area_ = kSteps / area;
  for (int i = 0; i < kSteps; ++i) {
    const double r = std::sqrt(std::max(0.0, (i - hair) * area / kSteps));
    floor_[static_cast<std::size_t>(i)] = profile_.height(std::min(radius(), r)) - hair;
  }
}

} // namespace pointmill
