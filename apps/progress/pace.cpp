// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "pace.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Before this share and this time nothing is said.
constexpr double kLeastShare = 0.05, kLeastSeconds = 2.0;
/// A change of the estimate comes in over about this time [s], so that it is calm.
constexpr double kCalm = 3.0;

} // namespace

void Pace::note(double seconds, double share)
{
  const double since = seconds - last_;
  last_ = seconds;
  if (share < kLeastShare || seconds < kLeastSeconds)
    return;
  const double estimate = seconds * (1 - share) / share;
  if (!left_) {
    left_ = estimate;
    return;
  }
  const double expected = std::max(0.0, *left_ - since);
  left_ = expected + (estimate - expected) * (1 - std::exp(-since / kCalm));
}

} // namespace pointmill
