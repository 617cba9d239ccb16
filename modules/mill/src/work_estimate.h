// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>

#include <vector>

namespace pointmill {

/// @brief What there is to know of how much work a job is; the presets stand for what
/// is not known before the scan is read.
struct JobSize {
  double points = 2e5;
  double area = 1e4, depth = 20; ///< of the part's box [mm2], [mm]
  bool smooth = true;            ///< quadrics between the points
};

/// @brief All stages of a job in their order, by rules of thumb that were measured on
/// parts of all kinds. They are not right anywhere, but in proportion nearly so.
std::vector<StageWork> workOf(const JobSize& size, const MillOptions& options);

} // namespace pointmill
