// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill_test {

/// @brief The part of data/sample_scan.pcd, 100 x 70 x 20 mm, as its upper surface.
struct SamplePart {
  static constexpr double length = 100;
  static constexpr double width = 70;

  /// @brief Height over the underside [mm], NaN beside the part and in its hole.
  static double height(double x, double y)
  {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const double outline = box(x, y, 0, 100, 0, 70, 6);
    const double hole = disc(x, y, 24, 14);
    if (outline > 0 || hole < 4)
      return nothing;
    double z = std::min(6.0, 5.0 - outline); // a chamfer of 1 mm along the outline
    z = std::min(z, groove(box(x, y, 55, 91, 9, 9, 0)));
    z = std::max(z, block(x, y, hole));
    return std::max(z, rosette(x - 72, y - 42));
  }

private:
  static double disc(double x, double y, double cx, double cy)
  {
    return std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy));
  }

  // Signed distance to a rectangle with corners of radius r, negative inside.
  static double
  box(double x, double y, double x0, double x1, double y0, double y1, double r)
  {
    const double u = std::abs(x - (x0 + x1) / 2) - ((x1 - x0) / 2 - r);
    const double v = std::abs(y - (y0 + y1) / 2) - ((y1 - y0) / 2 - r);
    return disc(std::max(u, 0.0), std::max(v, 0.0), 0, 0) +
           std::min(std::max(u, v), 0.0) - r;
  }

  // A ball-ended slot of radius 4 in the base, 3.5 deep, about a line at distance d.
  static double groove(double d) { return d < 4 ? 6.5 - std::sqrt(16 - d * d) : 6; }

  // The block with its step, pocket, boss and countersunk hole; 0 outside.
  static double block(double x, double y, double hole)
  {
    const double side = box(x, y, 5, 43, 5, 65, 3);
    if (side > 0)
      return 0;
    if (y < 23)
      return std::min({10.0, 10 - (1 + side), 10 - (6 - hole)});
    const double top = std::min({14.0, 14 - (1.5 + side), 14 - (24.5 - y)});
    const double pocket = box(x, y, 11, 37, 29, 59, 5);
    if (pocket > 0)
      return top;
    const double boss = disc(x, y, 24, 44) - 5.5;
    return boss < 0 ? std::min(12.0, 11.2 - boss) : 7.5;
  }

  // The freeform surface: a dome of radius 22 with nine twisted petals.
  static double rosette(double x, double y)
  {
    const double t = disc(x, y, 0, 0) / 22;
    if (t >= 1)
      return 0;
    const double petals = std::cos(9 * std::atan2(y, x) - 5 * t);
    const double depth = t * t * (3 - 2 * t);
    return 6 + 14 * std::pow(1 - t * t, 0.8) * (1 - 0.22 * depth * (1 - petals));
  }
};

} // namespace pointmill_test
