// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace pointmill::gcode {

/// @brief Axes of a plane by its G word in tenths: turning from @ref u to @ref v is
/// counter-clockwise, @ref w goes along.
struct ArcAxes {
  int u = 0, v = 1, w = 2;

  static ArcAxes of(int plane);
};

/// @brief An arc or helix. Where both radii differ the radius changes evenly.
class Arc {
public:
  /// @param centre along the plane's u and v
  Arc(const Eigen::Vector3d& from,
      const Eigen::Vector3d& to,
      const Eigen::Vector2d& centre,
      ArcAxes axes,
      bool clockwise);

  /// @brief From @p from by @p sweep [rad] about @p centre, and by @p rise along the
  /// plane's w; counter-clockwise where @p sweep is positive.
  static Arc turned(const Eigen::Vector3d& from,
                    const Eigen::Vector2d& centre,
                    ArcAxes axes,
                    double sweep,
                    double rise);

  double startRadius() const { return start_radius_; }
  double endRadius() const { return end_radius_; }
  /// @brief The angle travelled, above 0 [rad].
  double sweep() const { return sweep_; }
  /// @brief Length of the way [mm].
  double length() const;
  /// @brief How many chords keep within @p error of the arc [mm].
  std::size_t chords(double error) const;
  /// @brief End of chord @p i of @p n, 1 .. n; the last one is the arc's end itself.
  Eigen::Vector3d point(std::size_t i, std::size_t n) const;

private:
  Eigen::Vector3d from_, to_;
  Eigen::Vector2d centre_;
  ArcAxes axes_;
  bool clockwise_;
  double start_radius_ = 0.0, end_radius_ = 0.0;
  double start_angle_ = 0.0, sweep_ = 0.0;
};

/// @brief The centre of an arc by its radius, of which a negative one means the longer
/// way; nothing where the radius does not reach. Ends that differ.
std::optional<Eigen::Vector2d> centreByRadius(const Eigen::Vector2d& from,
                                              const Eigen::Vector2d& to,
                                              double radius,
                                              bool clockwise);

} // namespace pointmill::gcode
