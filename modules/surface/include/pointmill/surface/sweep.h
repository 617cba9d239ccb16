// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

namespace pointmill {

/// @brief Lowest height [mm] that the cutter's lower surface reaches over (x, y) while
/// its tip moves straight from @p a to @p b; infinite where it never passes over.
/// Closed forms, but for a slanted move whose lowest place over (x, y) is on the torus
/// of a bull nose: there a root, to rounding.
double sweptHeight(const CutterProfile& cutter,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   double x,
                   double y);
inline double sweptHeight(const Tool& tool,
                          const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b,
                          double x,
                          double y)
{
  return sweptHeight(tool.profile(), a, b, x, y);
}

/// @brief How deep [mm] the point @p p gets inside the cutter whose tip moves straight
/// from @p a to @p b: its distance to the cutter's surface from inside, or some number
/// <= 0 where it stays outside. The cutter reaches up without end; its top is no
/// surface. Beside a vertical wall this is the horizontal overlap, however high the
/// wall. On level moves, plunges and for balls a closed form, else a convex search (to
/// 1e-9 of the move).
double penetration(const CutterProfile& cutter,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& p);
inline double penetration(const Tool& tool,
                          const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b,
                          const Eigen::Vector3d& p)
{
  return penetration(tool.profile(), a, b, p);
}

/// @brief Squared distance [mm2] in XY from (x, y) to the segment @p a @p b.
inline double
segmentDistance2(double ax, double ay, double bx, double by, double x, double y)
{
  const double dx = bx - ax, dy = by - ay, len2 = dx * dx + dy * dy;
  double t = len2 > 0 ? ((x - ax) * dx + (y - ay) * dy) / len2 : 0.0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  const double ex = ax + t * dx - x, ey = ay + t * dy - y;
  return ex * ex + ey * ey;
}

} // namespace pointmill
