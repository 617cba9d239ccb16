// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/tool.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes how a part is bent as a PNG, seen from above (X right, Y up): blue on
/// ridges, brown in hollows, each the darker the tighter, after the larger of both
/// principal curvatures; grey where it is not known. The browns step where a hollow
/// becomes too tight for one of the round-ended @p tools, and hollows that are too
/// tight for all of them are hatched: there material stays. A bar under the map has a
/// mark at each tool.
/// @param hollow,ridge curvatures as mapCurvature() makes them [1/mm]
/// @param tools those whose end is no ball are left out
/// @throws DataError where a map is empty, not organised or without any curvature, both
/// are not of one size, or @p path cannot be written (nothing is left then)
void writeCurvature(const std::string& path,
                    const CellCloud& hollow,
                    const CellCloud& ridge,
                    const std::vector<Tool>& tools);

} // namespace pointmill
