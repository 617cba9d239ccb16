// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pointmill {
namespace align {

using Polygon = std::vector<Eigen::Vector2d>;

/// @brief A rectangle's sides [mm] and the direction of the long one, -90 < angle <= 90
/// degrees from X, in radians.
struct Rectangle {
  double angle = 0.0;
  double length = 0.0;
  double width = 0.0;
};

/// @brief The corners of the convex hull, counter-clockwise, none of them on a straight
/// edge. Points that are all equal or collinear yield one or two corners.
Polygon convexHull(std::vector<Eigen::Vector2d> points);

/// @brief The box of @p hull with one side at @p angle [rad].
Rectangle boxAt(const Polygon& hull, double angle);

/// @brief The enclosing rectangle of the smallest area, which has a side on an edge of
/// the hull, by rotating calipers.
Rectangle minimumRectangle(const Polygon& hull);

/// @brief The rotation [rad] that squares @p hull to the axes with the long side of its
/// minimum rectangle along X.
///
/// Of the two rotations that do, the smaller one (about 90 degrees: always the positive
/// one). A part whose sides differ by less than 1 % keeps the side that is nearer to X,
/// |angle| <= 45 degrees, and one whose present box is no more than 0.01 % larger than
/// the minimum is not turned by less than 90 degrees: such angles are noise.
double squaringAngle(const Polygon& hull);

} // namespace align
} // namespace pointmill
