// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {

/// @brief The outline of a cutter in a plane through its axis [mm], tip at height 0.
///
/// One formula for the whole family: a disc of radius `flat` at height `corner`, from
/// its rim a cone that leans outwards by `taper`, rolled round by a ball of radius
/// `corner`, and cut off by the shank's cylinder. The outline is convex. It goes up
/// without end: the top of a tool is no surface.
///
/// What every point needs is worked out once; take it out of loops for tapered tools.
class CutterProfile {
public:
  /// @brief A cylindrical cutter: flat, ball or bull-nose end mill.
  CutterProfile(double radius, double corner)
      : radius_(radius), flat_(radius - corner), corner_(corner), cone_first_(radius),
        cone_last_(radius)
  {
  }

  /// @brief A tapered cutter.
  /// @param taper half-angle between the cone and the axis [degrees], in (0, 90)
  /// @param shoulder rounding of the edge between cone and shank, in 0 .. corner
  CutterProfile(
      double radius, double flat, double corner, double taper, double shoulder);

  double radius() const { return radius_; }
  bool isBall() const { return flat_ <= 0.0 && sin_ == 0.0; }

  /// @brief Height of the lower surface at radius @p r; infinite beyond the cutter.
  double height(double r) const
  {
    if (r > radius_)
      return std::numeric_limits<double>::infinity();
    const double u = r - flat_;
    if (u <= 0.0)
      return 0.0;
    if (r <= cone_first_)
      return corner_ - legOf(corner_, u);
    if (r <= cone_last_)
      return corner_ + (u * cos_ - corner_) / sin_;
    return shoulder_height_ - legOf(shoulder_, r - (radius_ - shoulder_));
  }

  /// @brief Sine of the angle between the lower surface at radius @p r and the
  /// horizontal, which is the horizontal part of its unit normal: 0 on a flat end, the
  /// cosine of the taper on the cone, 1 where a rounding meets the shank. At a sharp
  /// edge that of the inner side.
  double steepness(double r) const;

  /// @brief How deep inside the cutter the place at radius @p r and height @p z lies:
  /// its distance to the surface; negative outside.
  double depth(double r, double z) const;

  /// @brief The value a in [@p lo, @p hi] that makes `height(sqrt(off^2 + a^2)) - fall
  /// * a` least: how far ahead [mm] of a place at @p off beside the track the axis
  /// stands when the cutter, on a move that sinks by @p fall per mm, is lowest over
  /// that place.
  /// @param off in 0 .. radius [mm]; @param fall > 0
  /// @param lo,hi where the axis may stand, the cutter over the place [mm]; negative
  /// where it has passed it
  double ahead(double off, double fall, double lo, double hi) const;

private:
  /// The other leg of a right triangle.
  static double legOf(double hypotenuse, double leg)
  {
    return std::sqrt(std::max(0.0, hypotenuse * hypotenuse - leg * leg));
  }

  double radius_, flat_, corner_, shoulder_ = 0.0;
  double sin_ = 0.0, cos_ = 1.0;  // of the taper
  double cone_first_, cone_last_; // radii where the cone begins and ends
  /// Of the centre of the shoulder's rounding.
  double shoulder_height_ = -std::numeric_limits<double>::infinity();
};

} // namespace pointmill
