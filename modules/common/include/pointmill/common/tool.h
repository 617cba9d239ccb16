// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/cutter_profile.h>

#include <algorithm>
#include <string>

namespace pointmill {

/// @brief A rotating cutter as a value [mm]: flat, ball and bull-nose end mills, their
/// tapered kinds, and cones. One formula describes them all, see CutterProfile.
struct Tool {
  int number = 1;
  double diameter = 10.0; ///< the largest that cuts; that of a tapered tool's shank
  /// 0: sharp; half the diameter (the tip diameter, where tapered): ball; between: bull
  double corner_radius = 0.0;
  double flute_length = 0.0; ///< 0: not given
  int flutes = 2;
  double taper = 0.0; ///< half-angle, between side and axis [degrees]; 0: cylindrical
  /// At the tip of a tapered tool: of a taper ball twice the corner radius, of a bull
  /// or a cone the flat end and both its corners. 0 where not tapered.
  double tip_diameter = 0.0;
  /// Rounding of the edge between cone and shank. 0, as tools are made; grown() rounds.
  double shoulder_radius = 0.0;
  /// @name What does not cut, above the flutes; 0: not given, and not checked [mm]
  /// @{
  double shank_diameter = 0.0;
  double stick_out = 0.0; ///< from the tip to the holder's face
  double holder_diameter = 0.0;
  /// @}

  static Tool flat(int number, double diameter)
  {
    return {number, diameter, 0.0, 0.0, 2};
  }
  static Tool ball(int number, double diameter)
  {
    return {number, diameter, diameter / 2, 0.0, 2};
  }
  static Tool bull(int number, double diameter, double corner)
  {
    return {number, diameter, corner, 0.0, 2};
  }
  /// @param half_angle between side and axis [degrees]
  /// @param diameter where the cone ends
  static Tool
  taperBall(int number, double tip_diameter, double half_angle, double diameter)
  {
    return taperBull(number, tip_diameter, tip_diameter / 2, half_angle, diameter);
  }
  static Tool taperBull(int number,
                        double tip_diameter,
                        double corner,
                        double half_angle,
                        double diameter)
  {
    return {number, diameter, corner, 0.0, 2, half_angle, tip_diameter};
  }
  /// @brief A V-bit or an engraving tool, with a flat on its tip or without.
  static Tool
  cone(int number, double half_angle, double diameter, double tip_diameter = 0.0)
  {
    return taperBull(number, tip_diameter, 0.0, half_angle, diameter);
  }

  double radius() const { return diameter / 2; }
  bool isTapered() const { return taper > 0.0; }
  /// @brief Whether the tool is a cylindrical end mill with a flat, or a round, end.
  bool isFlat() const { return !isTapered() && corner_radius <= 0.0; }
  bool isBall() const { return !isTapered() && corner_radius >= radius(); }
  /// @brief flat, ball, bull, taper (the rounded ones), or cone
  const char* type() const
  {
    return isTapered() ? corner_radius > 0.0 ? "taper" : "cone"
           : isFlat()  ? "flat"
           : isBall()  ? "ball"
                       : "bull";
  }

  /// @brief Radius of the end with its corners, without the cone.
  double tipRadius() const { return isTapered() ? tip_diameter / 2 : radius(); }
  /// @brief Radius of the disc that the cutter's end is flat on. Its middle does not
  /// cut: where there is one, the tool must not be sunk straight into material.
  double flatRadius() const
  {
    const double flat = tipRadius() - corner_radius;
    return flat > 1e-12 ? flat : 0.0; // grown() may round to either side of 0
  }
  /// @brief The width that the end of the tool clears, which step-over, step-down and
  /// feed in full cuts follow: a tapered tool's tip, of a sharp one a tenth of its
  /// diameter.
  double endDiameter() const
  {
    return isTapered() ? std::max(tip_diameter, diameter / 10) : diameter;
  }

  CutterProfile profile() const
  {
    return isTapered()
               ? CutterProfile(
                     radius(), flatRadius(), corner_radius, taper, shoulder_radius)
               : CutterProfile(radius(), corner_radius);
  }
  /// @brief Height of the cutter's lower surface above its tip at radius @p r [mm];
  /// infinite beyond the cutter.
  double profile(double r) const { return profile().height(r); }

  /// @brief The cutter whose surface lies @p allowance outside this one's. Its tip is
  /// `allowance` below this one's: a CL point of the grown tool, raised by `allowance`,
  /// leaves that much material along the surface normal.
  Tool grown(double allowance) const
  {
    Tool t = *this;
    t.diameter += 2 * allowance;
    t.corner_radius += allowance;
    if (isTapered()) {
      t.tip_diameter += 2 * allowance;
      t.shoulder_radius += allowance;
    }
    return t;
  }

  /// @brief Throws ParameterError where the numbers do not describe a cutter.
  void validate() const;
  /// @brief For people, as "T2 ball 5 mm" or "T4 taper ball 1 mm, 5 deg, to 6 mm".
  std::string describe() const;
};

} // namespace pointmill
