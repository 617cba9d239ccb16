// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tolerance_band.h>
#include <pointmill/surface/surface_model.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief A place of the tip and the surface's normal where the tool touches there.
struct CurvePoint {
  Eigen::Vector3d tip;
  Eigen::Vector3d normal;
};

/// @brief Turns a move between two CL points into chords that are proven to keep the
/// tool within a tolerance band of the true cutter-location curve; what BufferPoints
/// does to every chord.
///
/// Over points the curve is the upper envelope of arcs, one for each point within the
/// cutter's radius: `f_i(t) = z_i - profile(|p_i - c(t)|)`, concave, since the profile
/// is convex. So on a stretch of a chord, the chord's height above any one arc is
/// largest at the stretch's ends, and the envelope is no lower than that arc: where
/// both ends are within the band of the arc that the tool rests on midway, the whole
/// stretch is. Otherwise it is halved. Into the part, every point near the chord is
/// tried over its whole length (PointIndex::gouge).
class ChordRefiner {
public:
  /// @param tool the cutter; @p allowance what it leaves on the part [mm]
  /// @param floor the tip goes no lower than this [mm]
  /// @param shortest chords are not split below this length in XY [mm]; a leap of the
  ///        curve is passed by a vertical move on its free side
  ChordRefiner(const SurfaceModel& surface,
               const Tool& tool,
               double allowance,
               double floor,
               const ToleranceBand& band,
               double shortest)
      : surface_(surface), grown_(tool.grown(allowance)), allowance_(allowance),
        floor_(floor), band_(band), shortest_(shortest)
  {
  }

  /// @brief Where the tool comes to rest at (x, y); the tip is not below the floor.
  Contact rest(double x, double y) const;

  /// @brief Whether the chord from @p a to @p b stays within the band.
  bool holds(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  /// @brief Appends to @p path the points that lead from @p a (not appended) to @p b.
  /// Both must stand clear of the part.
  void
  refine(const Eigen::Vector3d& a, const CurvePoint& b, std::vector<CurvePoint>& path);

  /// @brief Vertical moves that were needed at leaps.
  std::size_t leaps() const { return leaps_; }

private:
  bool cutsIn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  bool followsCurve(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  void
  leap(const Eigen::Vector3d& a, const CurvePoint& b, std::vector<CurvePoint>& path);
  Eigen::Vector3d normalAt(double x, double y, const Contact& contact) const;

  const SurfaceModel& surface_;
  Tool grown_;
  double allowance_, floor_;
  ToleranceBand band_;
  double shortest_;
  std::size_t leaps_ = 0;
};

} // namespace pointmill
