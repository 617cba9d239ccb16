// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "steps.h"
#include "surroundings.h"
#include "tangent_circle.h"

#include <vector>

namespace pointmill {

enum class EntryKind { Open, Outside, Helix, Ramp, Plunge, Impossible };

/// @brief How the tool gets to the start of a pass. The first step is a place that it
/// can be sunk to straight through air, or swarf; the last one is the start.
struct Entry {
  EntryKind kind = EntryKind::Impossible;
  std::vector<Step> steps;

  const Eigen::Vector3d& from() const { return steps.front().to; }
};

/// @brief Finds entries: where material stands over the start level from outside, else
/// on a helix, else on a ramp along the pass, else straight down where the tool can.
class Entries {
public:
  /// @param helix_radius greatest radius of a helix, as a share of the end's diameter
  Entries(const Surroundings& around, double ramp_angle, double helix_radius)
      : around_(around), ramp_angle_(ramp_angle), helix_radius_(helix_radius)
  {
  }

  /// @param pass at least one place
  Entry into(const std::vector<Eigen::Vector3d>& pass) const;
  /// @brief The entry of a tool that comes level over the start at height @p z, through
  /// no more than a skin.
  Entry fromLink(const std::vector<Eigen::Vector3d>& pass, double z) const;

private:
  /// Height just above what stands at a place, and not below it.
  double lead(const Eigen::Vector3d& at, double radius) const;
  Entry fromOutside(const std::vector<Eigen::Vector3d>& pass) const;
  double widestHelix() const;
  Entry spiralDown(const TangentCircle& circle) const;
  Entry onHelix(const std::vector<Eigen::Vector3d>& pass) const;
  Entry downFrom(const std::vector<Eigen::Vector3d>& pass, double z) const;

  const Surroundings& around_;
  double ramp_angle_, helix_radius_;
};

} // namespace pointmill
