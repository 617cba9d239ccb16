// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

Bands::Bands(const std::vector<SweptMove>& moves,
             double y0,
             double height,
             int count,
             const std::function<double(const SweptMove&)>& reach)
    : bands_(static_cast<std::size_t>(std::max(1, count)))
{
  const auto band = [&](double y) {
    const double b = std::floor((y - y0) / height);
    return static_cast<int>(std::clamp(b, -1.0, bands_.size() * 1.0));
  };
  const int last = static_cast<int>(bands_.size()) - 1;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const auto& m = moves[k];
    const double r = reach(m);
    // a hair more on both sides, for points sorted in float32
    const int first = band(std::min(m.a.y(), m.b.y()) - r - 1e-3 * height);
    const int end = band(std::max(m.a.y(), m.b.y()) + r + 1e-3 * height);
    for (int b = std::max(0, first); b <= std::min(last, end); ++b)
      bands_[static_cast<std::size_t>(b)].push_back(static_cast<std::uint32_t>(k));
  }
}

} // namespace pointmill
