// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/contact.h>
#include <pointmill/surface/point_index.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace pointmill {

class Patch;
struct Neighbourhood;

/// @brief How a SurfaceModel fills the room between the points.
struct SmoothSurface {
  /// Points that a quadric is fitted to, at the contact.
  int neighbours = 24;
  /// A patch that its points lie further from (standard deviation, mm) is none: there
  /// is an edge, and the points themselves count.
  double fidelity = 0.005;
};

/// @brief The surface that a finishing cutter rests on.
///
/// Of bare points it is what PointIndex says, and the cutter sinks between them. A
/// smooth one lays a quadric through the neighbours of the contact point (moving least
/// squares in the plane of the points), made when it is asked for, and rests the cutter
/// on that too: never lower than on the bare points, nor on a patch beyond the points'
/// border or over an edge.
class SurfaceModel {
public:
  /// @brief Bare points.
  explicit SurfaceModel(std::shared_ptr<const PointIndex> points)
      : points_(std::move(points))
  {
  }
  /// @brief A smooth surface.
  /// @throws ParameterError for less than 12 or more than 1000 neighbours, or a
  ///         fidelity that is not positive
  SurfaceModel(std::shared_ptr<const PointIndex> points, const SmoothSurface& smooth);

  const PointIndex& points() const { return *points_; }
  bool isSmooth() const { return smooth_.neighbours > 0; }

  /// @brief Drops @p tool at (x, y) until it rests on the surface.
  Contact drop(const Tool& tool, double x, double y) const;

  /// @brief Drops @p tool at `count` places in a row, `from + i * step`; the same
  /// answers as drop(), sooner.
  void dropRow(const Tool& tool,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& step,
               std::size_t count,
               Contact* contacts) const;

private:
  void restOnPatch(const Tool& tool, double x, double y, Contact& contact) const;

  std::shared_ptr<const PointIndex> points_;
  SmoothSurface smooth_{0, 0.0};
};

} // namespace pointmill
