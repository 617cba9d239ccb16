// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "rough_parts.h"

#include <pointmill/link/link_passes.h>
#include <pointmill/rough/level_roughing.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

namespace bench {

using Points = pcl::PointCloud<pcl::PointXYZ>;

/// @brief How a part is roughed [mm].
struct RoughOptions {
  pointmill::Tool tool = pointmill::Tool::flat(1, 10.0);
  pointmill::Cutting cutting;
  double allowance = 0.5, step_down = 2.0, step_over = 4.0;
  double cell = 0.5;        ///< of the occupancy map
  double above = 0.0;       ///< stock above the part's highest point
  double clearance = 5.0;   ///< rapids go sideways so far above the stock
  double rapid_rate = 5000; ///< mm/min
};

/// @brief A part made ready for roughing, as `pointmill mill` does it.
struct RoughJob {
  /// @param points of the part, @p margin [mm] of stock beside them
  RoughJob(const Points::Ptr& points, double margin, const RoughOptions& options);

  RoughOptions options;
  pointmill::CellCloud::Ptr map;
  std::shared_ptr<const pointmill::PointIndex> part; ///< with what bridges its gaps
  pointmill::Stock stock;
  double floor; ///< lowest tip [mm]
};

/// @brief Points on @p part, @p step [mm] apart.
Points::Ptr sample(const RoughPart& part, double step);

/// @brief What still stands of the stock of a job, in both views that planning takes.
struct Standing {
  explicit Standing(const RoughJob& job);
  std::shared_ptr<pointmill::StockField> bound, nominal;
};

/// @brief The passes of a strategy on the whole of the stock.
pointmill::CLCloud planPasses(pointmill::LevelRoughing& roughing,
                              const RoughJob& job,
                              const Standing& standing);

/// @brief The passes linked; the stock is cut along.
pointmill::CLCloud linkPasses(pointmill::LinkPasses& linker,
                              const RoughJob& job,
                              const Standing& standing,
                              const pointmill::CLCloud& passes);

} // namespace bench
