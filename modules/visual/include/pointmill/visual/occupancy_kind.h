// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/visual/colour.h>

#include <pointmill/common/point_types.h>

namespace pointmill::visual {

/// @brief What a cell of an occupancy map is at a level.
enum class OccupancyKind { Free, Occupied, Protected };

inline OccupancyKind occupancyAt(const PointCell& cell, double level_z)
{
  if (cell.getState() == CellState::Gap) // NaN: unknown, protected
    return cell.z <= level_z ? OccupancyKind::Free : OccupancyKind::Protected;
  return cell.z > level_z ? OccupancyKind::Occupied : OccupancyKind::Free;
}

inline const Rgb& colourOf(OccupancyKind kind)
{
  static constexpr Rgb colours[] = {kFree, kOccupied, kProtected};
  return colours[static_cast<int>(kind)];
}

} // namespace pointmill::visual
