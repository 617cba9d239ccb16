// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "wall_lines.h"

#include <pointmill/rough/waterline_roughing.h>

namespace pointmill {

std::vector<LevelPath> WaterlineRoughing::clearLevel(const Level& level, Report&) const
{
  const CellGrid& grid = level.map().grid();
  const auto needed = level.neededNodes();
  std::vector<LevelPath> paths;
  for (const auto& wall : wallLines(level))
    for (auto& stretch : neededStretches(grid, needed, wall, level.stepOver())) {
      if (stretch.closed)
        stretch.points.push_back(stretch.points.front());
      LevelPath path;
      path.reversible = false;
      for (const auto& p : corners(stretch.points))
        path.points.push_back({level.at(p)});
      if (path.points.size() > 1)
        paths.push_back(std::move(path));
    }
  return paths;
}

std::vector<LevelPath> WaterlineRoughing::clearRest(const Level&,
                                                    Material& material) const
{
  material.leaveRest();
  return {};
}

} // namespace pointmill
