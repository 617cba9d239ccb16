// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <string>

namespace pointmill {

/// @brief Writes a map of the points' spacing, as SpacingMap makes it, as a PNG, seen
/// from above (X right, Y up) with square cells: dark where the points are dense, pale
/// where they are sparse, grey where there are none. The scale begins at 0 and ends at
/// the worst spacing of the map.
/// @throws DataError where the map is empty, not organised or without any spacing, or
/// @p path cannot be written (nothing is left then)
void writeSpacing(const std::string& path, const CellCloud& map);

} // namespace pointmill
