// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pointmill {

/// @brief One finding of a verification as its picture shows it, in the part frame
/// [mm].
struct FindingMark {
  std::string code; ///< "gouge", "rapid_in_stock", ...
  std::string text; ///< one sentence for people
  std::string note; ///< said in its section where no dimension shows `worst`
  bool warning = false;
  std::string where; ///< in the program, "line 12", as Program::where() says it
  int tool = 0;      ///< number of one of the scene's tools; 0: none
  /// The depth that it was found with, where it is a length [mm]: decides which
  /// findings get a section, and whether that shows the depth along the normal or
  /// straight down. What the section would measure otherwise is no dimension of it.
  double worst = 0;
  std::optional<Eigen::Vector3d> place; ///< of the part or stock; none: list only
  /// The tool's tip where it is worst. Where there is none, it stands on `move` where
  /// it is deepest in `place`; without both no tool is drawn.
  std::optional<Eigen::Vector3d> tip;
  /// The tip's way in that line of the program; places that are not finite are left
  /// out.
  std::vector<Eigen::Vector3d> move;
};

/// @brief What the picture of the findings shows, in the part frame [mm]. Nothing is
/// copied; null members leave their part of the picture out.
struct FindingScene {
  std::string title; ///< what was judged, "bracket.pcd" or "program.ngc"
  const pcl::PointCloud<pcl::PointXYZ>* part = nullptr;
  const CellCloud* milled = nullptr; ///< height field after the program, organised;
                                     ///< NaN: nothing left
  Stock stock;                       ///< a box without an area is not drawn
  std::vector<Tool> tools;
  std::vector<FindingMark> findings; ///< numbered 1, 2, ... in this order
};

/// @brief Writes a PNG that says why a program was refused, or what it was passed with:
/// the part from above (X right, Y up) with a number at each finding's place, the list
/// of the findings, and for the worst three that have a place of their own a vertical
/// section at one scale for both axes: the part's points beside it, what is left of the
/// stock, and the tool's true outline, with the depth of the place in the tool as a
/// dimension.
///
/// A section runs through the tool's axis and the place, along X or Y where they allow
/// it; without a tool along X or Y, whichever shows more relief. It is drawn in
/// software; the same scene gives the same bytes.
/// @param width of the picture [px], 1000 .. 3000; its height follows from the findings
/// @throws ParameterError for another width or a tool that is none; DataError where a
/// field is empty or not organised, or @p path cannot be written (nothing is left then)
void writeFindings(const std::string& path,
                   const FindingScene& scene,
                   int width = 1800);

/// @brief Writes the section through the place of one of the scene's findings, whether
/// it is among the worst or not, with its key.
/// @param finding its place in the list, from 0
/// @param width of the picture [px], 500 .. 2000
/// @return whether it has a place; without one nothing is written
/// @throws as writeFindings(), and ParameterError where there is no such finding
bool writeSection(const std::string& path,
                  const FindingScene& scene,
                  std::size_t finding,
                  int width = 900);

} // namespace pointmill
