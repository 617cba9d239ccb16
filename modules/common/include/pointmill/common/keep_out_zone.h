// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/cutter_profile.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief A place where no tool may be, as a clamp takes it: an upright prism over a
/// simple polygon or a disc [mm]. It ends at its top and reaches down without end.
///
/// A disc is the polygon of one corner, its centre, grown by its radius. All distances
/// are exact, in XY, and 0 inside. A zone grown by a margin is what lies at a distance
/// of no more than that, so its corners are round; its top is flat and as much higher.
class KeepOutZone {
public:
  /// @brief Between two opposite corners, in any order.
  static KeepOutZone box(double x0, double y0, double x1, double y1, double top);
  static KeepOutZone cylinder(double x, double y, double radius, double top);
  /// @param corners in either sense, not closed; the outline need not be convex
  static KeepOutZone polygon(std::vector<Eigen::Vector2d> corners, double top)
  {
    return KeepOutZone(std::move(corners), 0.0, top);
  }

  /// @brief Throws ParameterError unless all numbers are finite and the outline is
  /// simple and has an area.
  void validate() const;

  /// @brief Of the outline; a disc has its centre alone.
  const std::vector<Eigen::Vector2d>& corners() const { return corners_; }
  double radius() const { return radius_; } ///< of a disc; 0 of others
  double top() const { return top_; }
  /// @name The zone's box in XY
  /// @{
  const Eigen::Vector2d& min() const { return min_; }
  const Eigen::Vector2d& max() const { return max_; }
  /// @}

  /// @brief From (x, y) to the zone.
  double distance(double x, double y) const;
  /// @brief From the nearest place of the segment (ax, ay) (bx, by).
  double distanceAlong(double ax, double ay, double bx, double by) const;
  /// @brief From the nearest place of the rectangle @p low .. @p high.
  double distanceOver(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  /// @brief How deep [mm] the zone, grown by @p margin, gets inside the cutter whose
  /// tip moves straight from @p a to @p b: the greatest depth of any of its points, see
  /// CutterProfile::depth(), or some number <= 0 where it stays outside. A closed form
  /// on level and vertical moves, else a convex search for each edge (to 1e-9 of the
  /// move).
  double depth(const CutterProfile& cutter,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               double margin) const;

  /// @brief For people, as "cylinder at (10, 5), radius 8, up to 20 mm".
  std::string describe() const;

private:
  KeepOutZone(std::vector<Eigen::Vector2d> corners, double radius, double top);

  bool isDisc() const { return corners_.size() == 1; }
  /// Whether the polygon alone, without the radius, holds a place.
  bool holds(double x, double y) const;
  /// Calls f(corner, next corner) for each edge.
  template <typename F>
  void forEachEdge(F&& f) const;

  std::vector<Eigen::Vector2d> corners_;
  double radius_, top_;
  Eigen::Vector2d min_, max_;
};

} // namespace pointmill
