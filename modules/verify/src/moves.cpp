// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

Bands::Bands(double y0, double height, int count)
    : y0_(y0), height_(height), bands_(static_cast<std::size_t>(std::max(1, count)))
{
}

void Bands::add(std::size_t id, double ya, double yb, double reach)
{
  const auto band = [&](double y) {
    const double b = std::floor((y - y0_) / height_);
    return static_cast<int>(std::clamp(b, -1.0, bands_.size() * 1.0));
  };
  const int last = count() - 1;
  // a hair more on both sides, for points sorted in float32
  const int first = band(std::min(ya, yb) - reach - 1e-3 * height_);
  const int end = band(std::max(ya, yb) + reach + 1e-3 * height_);
  for (int b = std::max(0, first); b <= std::min(last, end); ++b)
    bands_[static_cast<std::size_t>(b)].push_back(static_cast<std::uint32_t>(id));
}

} // namespace pointmill
