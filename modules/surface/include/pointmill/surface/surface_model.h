// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/contact.h>
#include <pointmill/surface/point_index.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace pointmill {

/// @brief The surface that a finishing cutter rests on: bare points, or what lies
/// smoothly between them.
class SurfaceModel {
public:
  explicit SurfaceModel(std::shared_ptr<const PointIndex> points)
      : points_(std::move(points))
  {
  }

  const PointIndex& points() const { return *points_; }

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
  std::shared_ptr<const PointIndex> points_;
};

} // namespace pointmill
