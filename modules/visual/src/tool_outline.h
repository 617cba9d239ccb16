// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill::visual {

/// @brief What a tool is made of, as far as it is given: cutter, shank and holder, each
/// turned about the axis. Radius and height over the tip [mm].
class ToolOutline {
public:
  enum class Body { None, Cutter, Shank, Holder };

  explicit ToolOutline(const Tool& tool);

  /// @brief Which body the place is in; the widest where bodies overlap.
  Body at(double r, double z) const;
  /// @brief How deep inside the tool a place lies: its distance to the nearest surface
  /// of the body that it is deepest in; negative outside.
  double depth(double r, double z) const;
  /// @brief That nearest place of the surface, for a place inside the tool.
  Eigen::Vector2d nearest(double r, double z) const;
  /// @brief Height of the cutter's lower surface; infinite beyond its radius.
  double lower(double r) const { return cutter_.height(r); }
  double radius() const { return cutter_.radius(); }

private:
  /// Shank and holder: cylinders that go up without end.
  struct Cylinder {
    Body body;
    double radius, foot;
    double depth(double r, double z) const { return std::min(radius - r, z - foot); }
  };
  Eigen::Vector2d nearestOnCutter(double r, double z) const;

  CutterProfile cutter_;
  std::vector<Cylinder> cylinders_;
};

/// @brief The place on a way of the tip where the tool is deepest over @p place.
/// @param way places of the tip, not empty [mm]
Eigen::Vector3d deepestOn(const std::vector<Eigen::Vector3d>& way,
                          const ToolOutline& tool,
                          const Eigen::Vector3d& place);

} // namespace pointmill::visual
