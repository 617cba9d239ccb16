// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief One operation of a preview.
struct PreviewOperation {
  std::string label; ///< as its legend shows it, "1  roughing, T1 flat 10 mm"
  const CLCloud* path = nullptr;
  int colour = -1; ///< which of the palette's colours; -1: its place in the list
};

/// @brief What a preview shows, in the part frame [mm], Z up. Null members leave their
/// part of the picture out; nothing is copied.
struct PreviewScene {
  std::string title;
  const pcl::PointCloud<pcl::PointXYZ>* scan = nullptr; ///< the aligned part
  const CellCloud* map = nullptr; ///< occupancy map, organised; shows the gaps
  Stock stock;                    ///< a box without volume is not drawn
  std::vector<PreviewOperation> operations;
  const CellCloud* milled = nullptr; ///< height field after the program, organised;
                                     ///< NaN: nothing left
  std::vector<std::string> figures;  ///< short lines under the pictures
};

/// @brief Writes a PNG of the scan, the tool paths and the milled part side by side,
/// all seen from the front, left and above at one scale. It is drawn in software: no
/// display is needed. The same scene gives the same bytes.
/// @param width,height size of the picture [px], 640 x 360 .. 8000 x 8000
/// @throws ParameterError for another size; DataError where there is nothing to show,
/// a map is empty or not organised, or @p path cannot be written (nothing is left then)
void writePreview(const std::string& path,
                  const PreviewScene& scene,
                  int width = 2100,
                  int height = 900);

} // namespace pointmill
