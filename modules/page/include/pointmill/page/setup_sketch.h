// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/page/html.h>

#include <Eigen/Core>

namespace pointmill {

/// @brief What the one who sets up must place, in the part frame [mm].
struct SetupScene {
  Stock stock;
  Eigen::Vector3d part_min, part_max;
  const CellCloud* part = nullptr; ///< its height field, organised; null: its box
  const KeepOut* keep_out = nullptr;
  double clearance = 0; ///< plane of the sideways rapids
  double lowest = 0;    ///< tip
};

/// @brief Stock, part, datum, zones and heights from above and, under that, from the
/// front, at one scale and with dimensions, as SVG; then a list of the heights, which
/// is seen where the page is too narrow for their names in the drawing.
Html setupSketch(const SetupScene& scene);

} // namespace pointmill
