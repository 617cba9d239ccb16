// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "camera.h"
#include "frame.h"
#include "grid.h"

namespace pointmill::visual {

/// @brief What the parts of a height field are drawn as; None: not at all.
struct FieldLook {
  Surface top = Surface::None; ///< cells with a height
  Surface gap = Surface::None; ///< cells of CellState::Gap
  Surface raw = Surface::None; ///< cells at `raw_z` or higher, and the outer walls
  double raw_z = std::numeric_limits<double>::infinity(); ///< mm
  double floor = 0.0; ///< the outer walls' foot [mm]
};

/// @brief Draws the field as a surface through its cells' centres, with steps as walls
/// and, where `look.raw` is given, walls from its outline down to the floor.
void drawField(Frame& frame, const Camera& camera, const Grid& grid, const FieldLook&);

} // namespace pointmill::visual
