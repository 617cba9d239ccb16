// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/point_index.h>
#include <pointmill/surface/stock_field.h>

namespace pointmill {

/// @brief Stock that is no box: a casting or a sawn piece, as it was scanned. Each cell
/// is as high as the highest point near it; where there is none it is as high as the
/// box, since what was not seen may be there.
/// @param box round all of it [mm]
/// @param reach a point counts for places no further away than this [mm]; at least the
///        spacing of the points
StockField stockOf(const Stock& box,
                   double cell,
                   StockField::Bound bound,
                   const PointIndex& raw,
                   double reach);

} // namespace pointmill
