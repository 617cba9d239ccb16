// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "steps.h"

#include <pointmill/link/cut_meter.h>

#include <optional>

namespace pointmill {

/// @brief Builds a path point by point: sets feeds, cuts the stock and measures what is
/// cut.
class PathBuilder {
public:
  /// @param stock an upper bound, @param nominal nominal heights; either may be null
  PathBuilder(const Tool& tool,
              const Cutting& cutting,
              StockField* stock,
              StockField* nominal,
              CLCloud& path);

  /// @brief A move to where the tool is already is left out.
  void add(const Eigen::Vector3d& to, Motion motion, const PointCL& like)
  {
    add(to, motion, like, false);
  }
  /// @brief A lead-in straight down through what is proven to be air: at full feed.
  void addThroughAir(const Eigen::Vector3d& to, const PointCL& like)
  {
    add(to, Motion::LeadIn, like, true);
  }

  bool empty() const { return path_.empty(); }
  const PointCL& last() const { return path_.back(); }
  Eigen::Vector3d at() const { return position(path_.back()); }
  CutFigures figures() const { return meter_ ? meter_->figures() : CutFigures(); }
  /// @brief What links at feed have taken [mm3].
  double linkVolume() const { return link_volume_; }

private:
  void add(const Eigen::Vector3d& to, Motion motion, const PointCL& like, bool air);
  double
  feed(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Motion motion, bool air);

  const Tool& tool_;
  const Cutting& cutting_;
  StockField* stock_;
  std::optional<CutMeter> meter_;
  CLCloud& path_;
  double link_volume_ = 0;
};

} // namespace pointmill
