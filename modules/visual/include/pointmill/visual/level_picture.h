// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pointmill {

/// @brief What the picture of one level shows, in the part frame [mm]. Nothing is
/// copied.
struct LevelScene {
  std::string title;
  const CellCloud* map = nullptr;      ///< occupancy map of the part, organised
  const CellCloud* standing = nullptr; ///< height field of the stock before the level,
                                       ///< organised; null: all of the stock stands
  Stock stock;
  Tool tool;
  const CLCloud* path = nullptr;    ///< of the whole operation, passes linked
  std::uint32_t level = 0;          ///< the moves that arrive on it are shown
  std::vector<std::string> figures; ///< short texts under the title
};

/// @brief Height of a level [mm]: that of the lowest tip of a cut on it.
/// @throws DataError where @p path cuts nothing on @p level
double heightOfLevel(const CLCloud& path, std::uint32_t level);

/// @brief Writes a PNG of one level of a roughing operation, seen from above (X right,
/// Y up): the part where it is higher than the level, protected gaps, the stock that
/// the level finds, what the tool's end sweeps of it, and the moves. Cuts are coloured
/// by their order, links, entries and rapids have colours of their own, and a ring
/// marks each place where the tool comes down. It is drawn in software; the same scene
/// gives the same bytes.
/// @param width of the picture [px], 400 .. 4000; its height follows from the stock
/// @throws ParameterError for another width or a tool that is none; DataError where the
/// map or the path is missing, a map is empty or not organised, the stock has no area,
/// nothing is cut on the level, or @p path cannot be written (nothing is left then)
void writeLevel(const std::string& path, const LevelScene& scene, int width = 900);

} // namespace pointmill
