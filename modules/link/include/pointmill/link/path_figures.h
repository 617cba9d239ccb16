// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/link/cut_meter.h>

#include <cstddef>

namespace pointmill {

/// @brief Lengths and time of a path, and what it takes from the stock.
struct PathFigures {
  std::size_t cl_points = 0, passes = 0;
  std::size_t retracts = 0;  ///< up to the clearance plane
  double cutting_length = 0; ///< feed moves, mm
  double rapid_length = 0;   ///< mm
  double minutes = 0;        ///< feed moves at their feed, rapids at the rapid rate
  CutFigures cut;            ///< zeros where nothing was measured
};

/// @param rapid_rate mm/min
/// @param cut what was measured while the path was linked (LinkPasses::getCutFigures)
///        or afterwards (measureCut)
PathFigures
measurePath(const CLCloud& path, double rapid_rate, const CutFigures& cut = {});

} // namespace pointmill
