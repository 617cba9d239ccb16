// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "surroundings.h"

#include <vector>

namespace pointmill {

/// @brief Quarter circles on which a tool comes tangentially to a level pass and leaves
/// it. They lie where the part is proven clear and no more is cut than a skin, or on
/// the way in than what the pass itself cuts at its start.
class LeadArcs {
public:
  /// @param radius of the arcs [mm]; 0: none
  LeadArcs(const Surroundings& around, double radius) : around_(around), radius_(radius)
  {
  }

  /// @brief From the arc's first place, where nothing stands, to the start of @p pass.
  /// @return empty where there is none
  std::vector<Eigen::Vector3d> into(const std::vector<Eigen::Vector3d>& pass) const;
  /// @brief From the end of a pass that has been cut.
  std::vector<Eigen::Vector3d> outOf(const std::vector<Eigen::Vector3d>& pass) const;

private:
  using Way = std::vector<Eigen::Vector3d>;
  struct Load {
    double section, depth; // [mm2], [mm]
  };
  /// The arc that takes least, of those that take no more than @p most.
  Way best(const Way& onwards, const Load& most, bool open) const;
  Load loadOf(const Way& way) const;

  const Surroundings& around_;
  double radius_;
};

} // namespace pointmill
