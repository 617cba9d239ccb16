// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/tool.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Feeds and speeds of one operation.
struct Cutting {
  double spindle = 10000.0; ///< rev/min
  double feed = 1000.0;     ///< mm/min along the path
  double plunge_feed = 300; ///< mm/min downwards into material
  bool coolant = true;      ///< flood coolant, M8
};

/// @brief One tool doing one job: all of its moves, in machining order. The path begins
/// and ends with the tool's tip on the clearance plane.
struct Operation {
  std::string name;
  Tool tool;
  Cutting cutting;
  CLCloud path;
};

} // namespace pointmill
