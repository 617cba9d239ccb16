// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/surface/point_index.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace pointmill {

/// @brief A perfect pass of a tool: one that rests everywhere on the part, but no lower
/// than @p floor, and above keep-out zones.
class PerfectPass {
public:
  PerfectPass(const PointIndex& part,
              const Tool& tool,
              double floor,
              unsigned threads,
              KeepOut keep_out = KeepOut());
  ~PerfectPass();

  /// @brief The height [mm] that it leaves over each of @p points, which may be others
  /// than the part's. Within @p close [mm] of the point it is not searched any better.
  std::vector<float> heightsOver(const PointIndex& points, double close) const;

private:
  class RestGrid;
  class TileSearch;
  class Refinement;

  /// The tip comes no lower at (x, y), even without the part.
  double lowest(const CutterProfile& cutter, double x, double y) const
  {
    return keep_out_.empty() ? floor_
                             : std::max(floor_, keep_out_.lowest(cutter, x, y));
  }

  const PointIndex& part_;
  Tool tool_;
  double floor_;
  KeepOut keep_out_;
  unsigned threads_;
  std::unique_ptr<const RestGrid> grid_;
};

} // namespace pointmill
