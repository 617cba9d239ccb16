// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "wall_lines.h"

#include <pointmill/common/watch.h>
#include <pointmill/rough/waterline_roughing.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

namespace {
constexpr double kSkinTop = 1e-3; // what stands no higher is no skin [mm]
}

void WaterlineRoughing::checkParameters() const
{
  LevelRoughing::checkParameters();
  validateParameters(*this, getName());
}

std::vector<LevelPath> WaterlineRoughing::clearLevel(const Level& level, Report&) const
{
  const auto nodes = level.neededNodes();
  const double reach = level.map().endRadius() - min_skin_;
  const auto cuts = [&](const Eigen::Vector2d& p) {
    if (!nominal_)
      return isSetNear(level.map().grid(), nodes, p);
    // highest() looks half a diagonal further, for bounds.
    const double radius = reach - nominal_->cellSize() * std::sqrt(0.5);
    return radius > 0 && nominal_->highest(p.x(), p.y(), radius) > level.z() + kSkinTop;
  };
  std::vector<LevelPath> paths;
  for (const auto& wall : wallLines(level)) {
    checkInterrupted();
    for (auto& stretch : neededStretches(wall, cuts, level.stepOver())) {
      if (stretch.closed)
        stretch.points.push_back(stretch.points.front());
      LevelPath path;
      path.reversible = false;
      for (const auto& p : corners(stretch.points))
        path.points.push_back({level.at(p)});
      if (path.points.size() > 1)
        paths.push_back(std::move(path));
    }
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
