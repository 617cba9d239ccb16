// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/link/link_passes.h>

namespace pointmill {

/// @brief What stands round a tool that goes from pass to pass, and how low it may go.
struct Surroundings {
  Tool tool;
  double clearance, approach; ///< see LinkPasses [mm]
  const StockField* stock;    ///< upper bound, or null
  const StockField* nominal;  ///< or null
  const PointIndex* part;     ///< or null: nothing is proven clear
  double allowance, floor;    ///< [mm]
  const KeepOut& keep_out;

  /// @brief Radius within which a pass over a place has certainly cut.
  double certainRadius() const;
  /// @brief Highest stock within a radius of a straight way.
  double standing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) const;
  double standing(const Eigen::Vector3d& at, double r) const
  {
    return standing(at, at, r);
  }
  /// @brief The lowest tip height of a level straight move at feed that leaves the part
  /// its allowance; infinite without a part.
  double lowestOver(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// @brief Whether the level moves between neighbours of @p way are clear of the part.
  bool isClear(const std::vector<Eigen::Vector3d>& way) const;
  /// @brief What a machine that moves its axes one after the other, in any order or at
  /// any speeds, may meet between two places: the highest stock, part or zone
  /// within the cutter's radius of the box that they span.
  double highestInBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  /// @brief Depth and volume that a way would take from the stock.
  Cut cutOf(const std::vector<Eigen::Vector3d>& way) const;
  /// @brief Whether nothing stands above @p at under the whole cutter.
  bool isOpen(const Eigen::Vector3d& at) const;
};

} // namespace pointmill
