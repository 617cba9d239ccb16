// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "work_estimate.h"

#include <pointmill/finish/raster.h>

#include <algorithm>

namespace pointmill {

std::vector<StageWork> workOf(const JobSize& size, const MillOptions& options)
{
  const double million = size.points / 1e6;
  const double litres = size.area * std::max(size.depth, 1.0) / 1e6;
  const double roughing = 8 * litres + 3.5 * million;
  // Rows, of each ten metres.
  const auto rows = [&](const ToolJob& job, double scallop) {
    const double step =
        stepOverForScallop(std::max(job.tool.corner_radius, 0.1), scallop);
    return size.area / step / 1e4 * (size.smooth ? 3.0 : 0.6);
  };
  const double finishing = rows(options.finish, options.scallop);
  std::vector<StageWork> work{{"read", 0.1 * million},
                              {"prepare", 0.1 * million},
                              {"align", 0.8 * million},
                              {"surface", (size.smooth ? 6.0 : 0.5) * million},
                              {"map", 0.1 + 0.1 * million},
                              {"stock", 0.01},
                              {"roughing", roughing}};
  if (options.rest)
    work.push_back({"rest roughing, T" + std::to_string(options.rest->tool.number),
                    0.35 * roughing});
  for (const auto& stage : std::vector<StageWork>{
           {"rest roughing", 0.35 * roughing},
           {"walls", 0.1 * roughing},
           {"semi-finishing", rows(options.semi, options.semi_scallop)},
           {"rest roughing, fine", 0.1 * roughing},
           {"walls, fine", 0.15 * roughing},
           {"finishing", finishing},
           {"write", 0.03 * finishing},
           {"verify", 8 * million + 0.6 * finishing},
           {"pictures", 1 + 4 * million},
           {"page", 0.1 + 0.1 * million},
           {"files", 0.05 + 0.2 * million}})
    work.push_back(stage);
  return work;
}

} // namespace pointmill
