// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "steps.h"

#include <pointmill/link/path_figures.h>

namespace pointmill {

PathFigures measurePath(const CLCloud& path, double rapid_rate, const CutFigures& cut)
{
  PathFigures figures;
  figures.cut = cut;
  figures.cl_points = path.size();
  std::uint32_t label = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 0 || path[i].label != label) {
      label = path[i].label;
      ++figures.passes;
    }
    if (i == 0)
      continue;
    const double length = (position(path[i]) - position(path[i - 1])).norm();
    const Motion motion = path[i].getMotion();
    figures.retracts += motion == Motion::Retract;
    if (isRapid(motion)) {
      figures.rapid_length += length;
      figures.minutes += length / rapid_rate;
    }
    else {
      figures.cutting_length += length;
      figures.minutes += length / path[i].feed;
    }
  }
  return figures;
}

} // namespace pointmill
