// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/surface_model.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief Turns a move between two CL points into chords that keep the tool within a
/// tolerance of the true cutter-location curve; what BufferPoints does to every chord.
class ChordRefiner {
public:
  /// @param tool the cutter; @p allowance what it leaves on the part [mm]
  /// @param floor the tip goes no lower than this [mm]
  /// @param tolerance how deep a chord may cut into a point, and how far it may stay
  /// above
  ///        the true curve along its normal [mm]
  /// @param shortest chords are not split below this length in XY [mm]; a leap of the
  ///        curve is passed by a vertical move on its free side
  ChordRefiner(const SurfaceModel& surface,
               const Tool& tool,
               double allowance,
               double floor,
               double tolerance,
               double shortest)
      : surface_(surface), grown_(tool.grown(allowance)), allowance_(allowance),
        floor_(floor), tolerance_(tolerance), shortest_(shortest)
  {
  }

  /// @brief The lowest tip height at (x, y).
  double lowest(double x, double y) const;

  /// @brief Appends to @p path the points that lead from @p a (not appended) to @p b.
  /// Both must stand clear of the part.
  void refine(const Eigen::Vector3d& a,
              const Eigen::Vector3d& b,
              std::vector<Eigen::Vector3d>& path);

  /// @brief Vertical moves that were needed at leaps.
  std::size_t leaps() const { return leaps_; }

private:
  bool cutsIn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  bool staysHigh(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  void leap(const Eigen::Vector3d& a,
            const Eigen::Vector3d& b,
            std::vector<Eigen::Vector3d>& path);

  const SurfaceModel& surface_;
  Tool grown_;
  double allowance_, floor_, tolerance_, shortest_;
  std::size_t leaps_ = 0;
};

} // namespace pointmill
