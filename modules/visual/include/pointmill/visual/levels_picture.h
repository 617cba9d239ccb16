// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes an occupancy map at many levels as one PNG, small pictures in the
/// colours of writeOccupancy() side by side from the top down, each with its height
/// [mm]. Of more than 60 levels some are left out, evenly, and the title says so.
/// @param levels heights [mm], descending
/// @throws DataError where the map is empty or not organised, there are no levels, or
/// @p path cannot be written (nothing is left then)
void writeLevels(const std::string& path,
                 const CellCloud& map,
                 const std::vector<double>& levels);

} // namespace pointmill
