// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/surface/patch.h>

#include <cstddef>

namespace pointmill {

/// @brief Principal curvatures of a surface [1/mm]: positive where it is hollow seen
/// from above, so that a ball of a larger radius than 1 / hollow does not get in.
struct Curvatures {
  double hollow = 0; ///< the larger
  double ridge = 0;  ///< the smaller
};

/// @brief Those of a patch over (s, t), from its two fundamental forms.
Curvatures curvaturesOf(const Patch& patch, double s, double t);

/// @brief The principal curvatures of a part, place by place, as organised clouds of
/// cells whose `z` is not a height but a curvature [1/mm]; 0 where it cannot be told
/// from the points' noise, NaN where there is no part or no quadric fits its points.
struct CurvatureMap {
  CellCloud hollow, ridge;
};

/// @brief Fits a quadric to the points round the top of each cell of @p map that holds
/// points. (pcl::PrincipalCurvaturesEstimation tells forms apart, but not in 1/mm: it
/// takes the scatter of the normals.)
/// @param map organised; where it has more than @p most cells, each of the result's
/// stands for several
/// @param neighbours points of a fit, 12 .. 1000
/// @param threads 0: as many as the machine has; the result is the same
/// @throws ParameterError, DataError
CurvatureMap mapCurvature(const PointIndex& points,
                          const CellCloud& map,
                          std::size_t neighbours = 40,
                          std::size_t most = 40000,
                          unsigned threads = 0);

} // namespace pointmill
