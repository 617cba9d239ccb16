// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "overlay.h"

#include <pointmill/viewer/viewer.h>
#include <pointmill/visual/deviation_scale.h>

#include <string>
#include <vector>

namespace pointmill::viewer {

/// @brief What is shown at the moment: finding, level, time, line, tool, place, feed.
std::string momentText(const ViewerScene& scene,
                       const std::vector<double>& levels,
                       const ViewerLook& look);

/// @brief Whether legendsOf() says the same of both.
inline bool sameLegends(const ViewerLook& a, const ViewerLook& b)
{
  return a.solid == b.solid && a.paths == b.paths && a.colouring == b.colouring &&
         a.rapids == b.rapids && a.map == b.map &&
         a.level.has_value() == b.level.has_value();
}

/// @brief What the colours mean that a look shows.
std::vector<Legend> legendsOf(const ViewerScene& scene,
                              const ViewerLook& look,
                              const visual::DeviationScale& scale);

} // namespace pointmill::viewer
