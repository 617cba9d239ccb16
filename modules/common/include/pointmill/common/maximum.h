// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cmath>

namespace pointmill {

/// @brief Largest value of the concave @p f on [@p lo, @p hi], by golden section to
/// 1e-9 of the interval.
template <typename F>
double maximumOf(double lo, double hi, F f)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double u = hi - golden * (hi - lo), v = lo + golden * (hi - lo);
  double fu = f(u), fv = f(v), best = std::max({f(lo), f(hi), fu, fv});
  for (int i = 0; i < 45; ++i) {
    if (fu > fv) {
      hi = v;
      v = u;
      fv = fu;
      u = hi - golden * (hi - lo);
      fu = f(u);
    }
    else {
      lo = u;
      u = v;
      fu = fv;
      v = lo + golden * (hi - lo);
      fv = f(v);
    }
    best = std::max({best, fu, fv});
  }
  return best;
}

} // namespace pointmill
