// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <string>

namespace pointmill {

/// @brief Writes any height field as a PNG, seen from above (X right, Y up) with square
/// cells: dark where it is low, pale where it is high, lit from the upper left, grey
/// where it has no height. The colours begin and end where nearly all heights lie,
/// which a bar says [mm].
/// @throws DataError where the field is empty, not organised or without any height, or
/// @p path cannot be written (nothing is left then)
void writeHeights(const std::string& path,
                  const CellCloud& field,
                  const std::string& title = "heights");

} // namespace pointmill
