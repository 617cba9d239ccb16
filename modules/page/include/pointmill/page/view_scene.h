// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/gcode/gcode_reader.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A stretch of a program that the view switches on and off.
struct ViewPath {
  std::string label; ///< "roughing, T1 flat 10 mm"
  int colour = 0;    ///< of the pictures' palette
  int tool = 0;
  std::size_t first = 0, last = 0; ///< of Program::moves, the last left out
  double seconds = 0;              ///< all that it takes
};

/// @brief What the 3D view of a page shows, in the part frame [mm]. Nothing is copied;
/// null members leave their part of the view out.
struct ViewScene {
  Stock stock;
  double clearance = 0;              ///< plane of the sideways rapids
  const CellCloud* part = nullptr;   ///< height field of the scan, organised
  const CellCloud* milled = nullptr; ///< the same after the program
  /// Signed, in the points' intensity; see Verification::deviations.
  std::shared_ptr<const pcl::PointCloud<pcl::PointXYZI>> deviation;
  double tolerance = 0.02; ///< of the deviations
  const KeepOut* keep_out = nullptr;
  std::vector<Tool> tools;
  const Program* program = nullptr;
  double rapid_rate = 5000; ///< mm/min
  std::vector<ViewPath> paths;
};

/// @brief How much of a scene goes into its view: what is finer is left out.
struct ViewLimits {
  int cells = 250; ///< along the longer side
  /// Chords may be as far off as the stock's diagonal over this, and further where the
  /// program would need more than so many corners.
  double chords = 2000;
  std::size_t corners = 300000;
};

/// @brief The scene as page/resources/view.js reads it: JSON in which no text ends a
/// script. The same scene gives the same bytes.
/// @throws DataError where a field is not organised
std::string viewJson(const ViewScene& scene, const ViewLimits& limits = {});

} // namespace pointmill
