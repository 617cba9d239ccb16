// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/viewer/cut_player.h>

#include <Eigen/Core>

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pointmill {

/// @brief Any cloud, with all its fields: shown as pcl_viewer does.
struct ViewedCloud {
  std::string name;
  pcl::PCLPointCloud2::Ptr cloud;
};

/// @brief One operation of a CL cloud: `count` points from `first` on.
struct ViewedOperation {
  std::string name; ///< "finishing, T3 ball 3 mm"
  int colour = 0;   ///< of the palette that previews take
  std::size_t first = 0, count = 0;
};

/// @brief A section of a program, and its colour of the palette. Sections of one name
/// are one operation.
struct ViewedSection {
  std::string name;
  int colour = 0;
};

/// @brief Something that the verification found.
struct ViewedFinding {
  std::string text; ///< "error gouge: ..." with its place
  bool error = false;
  std::size_t line = 0; ///< of the program; 0: none
  std::optional<Eigen::Vector3d> place;
};

/// @brief What a viewer shows, in the part frame [mm], Z up. What is empty or null is
/// not there.
struct ViewerScene {
  std::string title;
  std::vector<ViewedCloud> clouds;
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr part; ///< the scan as aligned
  CellCloud::ConstPtr map;                       ///< occupancy map, organised
  CLCloud::ConstPtr path;                        ///< all operations, in order
  std::vector<ViewedOperation> operations;       ///< of `path`
  /// Each point's intensity is the milled surface's signed distance from it [mm].
  pcl::PointCloud<pcl::PointXYZI>::ConstPtr deviation;
  double tolerance = 0.02; ///< deviations up to this are in order [mm]
  Stock stock;             ///< a box without volume is not there
  std::shared_ptr<CutPlayer> player;
  std::vector<ViewedSection> sections; ///< of the player's program
  std::vector<ViewedFinding> findings;
};

} // namespace pointmill
