// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/gaps.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes the gaps of a scan as a PNG: the map from above (X right, Y up) in
/// pale colours of its heights, each gap outlined and hatched after its treatment and
/// numbered, and under it a list with the area, kind and treatment of each. Cells that
/// were bridged between points are hatched lightly; outside the outline it is white.
/// @param gaps of the same map, the largest first; of many, the list tells the largest
/// @throws DataError where the map is empty or not organised, there is neither a gap
/// nor a cell between points, or @p path cannot be written (nothing is left then)
void writeGaps(const std::string& path,
               const CellCloud& map,
               const std::vector<GapRegion>& gaps);

} // namespace pointmill
