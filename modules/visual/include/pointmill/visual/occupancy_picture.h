// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <string>

namespace pointmill {

/// @brief Writes an occupancy map at height @p level_z [mm] as a PNG, seen from above
/// (X right, Y up) with square cells: red where the part is higher, yellow where it is
/// not, blue-grey where a gap's bridge is higher (or its height unknown), which is
/// protected from milling.
/// @throws DataError where the map is empty or not organised, or @p path cannot be
/// written (nothing is left then)
void writeOccupancy(const std::string& path, const CellCloud& map, double level_z);

} // namespace pointmill
