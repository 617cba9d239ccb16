// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

namespace pointmill {

/// @brief The deepest that a cutter resting on bare points gets below the surface that
/// they were taken from, along its normal [mm]; infinite where it can fall through.
///
/// A cutter that is sunk into a plane cuts it in an area without points. Seen from
/// above that area holds no disc larger than the largest void, so that the cutter sinks
/// at most until the largest disc in it has the void's radius, `a = spacing / sqrt(2)`,
/// see Spacing. This holds for every cutter whose profile is convex, every place of the
/// points, and every slope. It is
///
/// - `profile(a)` for any cutter on a level plane: `R - sqrt(R^2 - s^2 / 2)` for a
/// ball,
///   0 for a flat end that is wider than the void, whatever the spacing;
/// - `R - sqrt(R^2 - (a / cos)^2)` for a ball on a slope: what the wider spacing along
///   the slope gives on a level plane;
/// - `2 a sin` for a flat end on a slope: its rim touches, so that it falls as far as
///   the slope does across a void.
///
/// Ground that bulges adds to it as a smaller ball does, `1 / R + bulge` for `1 / R`;
/// hollow ground takes from it, for which 0 is a bound. On random points of density rho
/// a ball sinks `1 / (2 pi rho R)` on average on level ground, the mean of `d^2 / (2
/// R)` over places at a distance d from the nearest point.
///
/// What is bounded is the sinking between points within a plane or a paraboloid of that
/// curvature, which are exact: edges that lie between two points are not, nor is what
/// noise does, which lifts the cutter.
///
/// @param spacing edge of the square grid with the same largest void, in XY [mm]
/// @param slope of the plane [deg], below 90
/// @param bulge curvature of convex ground, as that of z over XY [1/mm]
/// @throws ParameterError where an argument is outside its range
double
sinkBetweenPoints(const Tool& tool, double spacing, double slope = 0, double bulge = 0);

} // namespace pointmill
