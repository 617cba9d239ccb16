// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <string>

namespace pointmill {

/// @brief Writes any height field as a PNG, seen from above (X right, Y up) with square
/// cells: dark where it is low, pale where it is high, lit from the upper left, grey
/// where it has no height. A bar says where the colours begin and end [mm]: at the
/// lowest and highest, or, marked by < and >, where few heights are far beyond.
/// @throws DataError where the field is empty, not organised or without any height, or
/// @p path cannot be written (nothing is left then)
void writeHeights(const std::string& path,
                  const CellCloud& field,
                  const std::string& title = "heights");

} // namespace pointmill
