// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pointmill {

/// @brief A rotating cutter as a value [mm]: flat, ball and bull end mills are one
/// formula, a disc of radius `diameter/2 - corner_radius` rolled round by
/// `corner_radius`.
struct Tool {
  int number = 1;
  double diameter = 10.0;
  double corner_radius =
      0.0; ///< 0: flat end; diameter / 2: ball end; between: bull nose
  double flute_length = 0.0; ///< 0: not given
  int flutes = 2;

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

  double radius() const { return diameter / 2; }
  bool isFlat() const { return corner_radius <= 0.0; }
  bool isBall() const { return corner_radius >= radius(); }
  const char* type() const { return isFlat() ? "flat" : isBall() ? "ball" : "bull"; }

  /// @brief Height of the cutter's lower surface above its tip at radius @p r [mm];
  /// infinite beyond the cutter.
  double profile(double r) const
  {
    if (r > radius())
      return std::numeric_limits<double>::infinity();
    const double u = r - (radius() - corner_radius);
    if (u <= 0.0)
      return 0.0;
    return corner_radius -
           std::sqrt(std::max(0.0, corner_radius * corner_radius - u * u));
  }

  /// @brief The cutter whose surface lies @p allowance outside this one's. Its tip is
  /// `allowance` below this one's: a CL point of the grown tool, raised by `allowance`,
  /// leaves that much material along the surface normal.
  Tool grown(double allowance) const
  {
    Tool t = *this;
    t.diameter += 2 * allowance;
    t.corner_radius += allowance;
    return t;
  }

  /// @brief Throws ParameterError where the numbers do not describe a cutter.
  void validate() const;
  /// @brief For people, as "T2 ball 5 mm".
  std::string describe() const;
};

} // namespace pointmill
