// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_map.h>
#include <pointmill/rough/narrow_place.h>

#include <vector>

namespace pointmill {

/// @brief What a roughing tool cannot get at, wherever it goes.
struct OutOfReach {
  std::vector<NarrowPlace> narrow; ///< the largest volume first
  double narrow_volume = 0;        ///< of all of them [mm3]
  double kept_out_volume = 0;      ///< that only zones keep it from [mm3]
};

/// @param cells the occupancy map that @p map was made of
/// @param floor lowest level [mm]
/// @param depth less than this above the part's allowance is no place [mm]
OutOfReach outOfReach(const LevelMap& map,
                      const CellCloud& cells,
                      double allowance,
                      double floor,
                      double depth);

} // namespace pointmill
