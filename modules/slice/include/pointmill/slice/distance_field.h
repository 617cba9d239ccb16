// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <vector>

namespace pointmill {

/// @brief Distance from every cell's centre to the nearest cell that is set, in cells;
/// infinite where none is. Exact and linear in the number of cells (lower envelope of
/// parabolas, Felzenszwalb and Huttenlocher 2012).
/// @param mask row-major, `columns * rows` values, set where not 0
std::vector<float>
distanceField(const std::vector<unsigned char>& mask, int columns, int rows);

} // namespace pointmill
