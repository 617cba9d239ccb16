// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/stock_field.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr int kRowsPerBand = 8;

/// A rapid may touch what it does not enter: what of the tool lies deeper than e
/// inside.
Tool shrunk(const Tool& tool, double e)
{
  Tool small = tool;
  small.diameter = std::max(0.0, tool.diameter - 2 * e);
  small.corner_radius = std::max(0.0, tool.corner_radius - e);
  small.tip_diameter = std::max(0.0, tool.tip_diameter - 2 * e);
  return small;
}

} // namespace

void judgeStock(const Stock& stock,
                double cell,
                const std::vector<SweptMove>& moves,
                double tolerance,
                unsigned threads,
                Verification& result)
{
  StockField field(stock, cell, StockField::Bound::Nominal);
  const int count = (field.rows() + kRowsPerBand - 1) / kRowsPerBand;
  const Bands bands(moves, stock.min.y(), kRowsPerBand * cell, count);
  std::map<const Tool*, Tool> rapid_tools;
  for (const auto& m : moves)
    rapid_tools.emplace(m.tool, shrunk(*m.tool, tolerance));

  struct Outcome {
    std::map<std::size_t, double> rapids; // move -> depth
    std::map<int, double> axial;
  };
  std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
  parallelFor(outcomes.size(), threads, [&](std::size_t band) {
    const int row0 = static_cast<int>(band) * kRowsPerBand;
    const int row1 = std::min(field.rows(), row0 + kRowsPerBand);
    Outcome& mine = outcomes[band];
    for (const auto k : bands[band]) {
      const SweptMove& m = moves[k];
      if (m.rapid) {
        const Eigen::Vector3d up(0, 0, tolerance);
        const double depth =
            field.cut(rapid_tools.at(m.tool), m.a + up, m.b + up, row0, row1).depth;
        if (depth > 0.01)
          mine.rapids[k] = depth;
      }
      else {
        const double depth = field.cut(*m.tool, m.a, m.b, row0, row1).depth;
        auto& deepest = mine.axial[m.tool->number];
        deepest = std::max(deepest, depth);
      }
    }
  });

  std::map<std::size_t, double> rapids;
  for (const auto& o : outcomes) {
    for (const auto& [k, depth] : o.rapids)
      rapids[k] = std::max(rapids[k], depth);
    for (const auto& [tool, depth] : o.axial)
      result.axial_depth[tool] = std::max(result.axial_depth[tool], depth);
  }
  result.rapids_in_stock = rapids.size();
  for (const auto& [k, depth] : rapids)
    if (depth > result.rapid_depth) {
      result.rapid_depth = depth;
      result.rapid_line = moves[k].line;
    }
  result.milled = field.toCloud();
}

} // namespace pointmill
