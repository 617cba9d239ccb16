// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief A closed stretch of a line, as distances along it [mm].
struct Span {
  double first, last;
};

/// @brief Where the tool's axis may be in XY: everywhere, or inside a polygon that is
/// grown by an overhang (shrunk, if that is negative). What is inside is told by the
/// even-odd rule; corners are grown round.
class Boundary {
public:
  /// @brief Everywhere.
  Boundary() = default;
  /// @param polygon its corners [mm], in either sense, not closed
  /// @param overhang how far the axis may leave it [mm]
  /// @throws ParameterError for fewer than three corners or one that is not finite
  Boundary(std::vector<Eigen::Vector2d> polygon, double overhang);

  bool everywhere() const { return polygon_.empty(); }

  /// @brief The stretches of the line `origin + t * direction` that lie inside, exactly
  /// and in order of t; @p direction is a unit vector. Not for everywhere().
  std::vector<Span> inside(const Eigen::Vector2d& origin,
                           const Eigen::Vector2d& direction) const;

  /// @brief The least and the greatest `p * axis` of all places p that may be inside.
  Span extent(const Eigen::Vector2d& axis) const;

private:
  std::vector<Eigen::Vector2d> polygon_;
  double overhang_ = 0.0;
};

} // namespace pointmill
