// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/visual/colour.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pointmill::visual {

/// @brief Colours of signed curvatures: blue on ridges, brown in hollows, which people
/// with any colour vision tell apart (after ColorBrewer's BrBG and RdBu). Hollows step
/// where they become too tight for a tool.
struct CurvatureScale {
  std::vector<double> steps; ///< ascending [1/mm]; may be empty
  double range = 1;          ///< where the colours end [1/mm]

  Rgb at(double curvature) const
  {
    constexpr Rgb flat = hex(0xF7F4EC), ridge = hex(0x0A3A70), middle = hex(0x8CC0DC);
    constexpr Rgb first = hex(0xF3D9AE), last = hex(0x5C3006);
    const double share = std::min(std::abs(curvature) / range, 1.0);
    if (curvature < 0)
      return share < 0.5 ? mix(flat, middle, float(2 * share))
                         : mix(middle, ridge, float(2 * share - 1));
    std::size_t passed = 0;
    while (passed < steps.size() && curvature > steps[passed])
      ++passed;
    if (passed == 0) {
      const double end = steps.empty() ? range : steps.front();
      return mix(flat, first, float(std::min(curvature / end, 1.0)));
    }
    return mix(first, last, float(passed) / float(steps.size()));
  }
  /// @brief Whether a hollow is too tight for every tool.
  bool isTooTight(double hollow) const
  {
    return !steps.empty() && hollow > steps.back();
  }
};

} // namespace pointmill::visual
