// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/parallel.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr std::size_t kBatch = 4096; // moves at once for a thread

} // namespace

void judgeKeepOut(const KeepOut& keep_out,
                  const std::vector<SweptMove>& moves,
                  double tolerance,
                  unsigned threads,
                  Verification& result)
{
  if (keep_out.empty())
    return;
  std::map<const Tool*, CutterProfile> cutters;
  for (const auto& m : moves)
    if (cutters.find(m.tool) == cutters.end())
      cutters.emplace(m.tool, m.tool->profile());

  struct Outcome {
    double depth = 0;
    std::size_t move = 0, count = 0;
  };
  std::vector<Outcome> outcomes((moves.size() + kBatch - 1) / kBatch);
  parallelFor(outcomes.size(), threads, [&](std::size_t batch) {
    Outcome& mine = outcomes[batch];
    const std::size_t end = std::min(moves.size(), (batch + 1) * kBatch);
    for (std::size_t k = batch * kBatch; k < end; ++k) {
      const SweptMove& m = moves[k];
      const CutterProfile& cutter = cutters.at(m.tool);
      const double depth =
          m.mayBend() ? keep_out.depthIn(cutter, m.a.cwiseMin(m.b), m.a.cwiseMax(m.b))
                      : keep_out.depth(cutter, m.a, m.b);
      mine.count += depth > tolerance;
      if (depth > mine.depth) {
        mine.depth = depth;
        mine.move = k;
      }
    }
  });

  for (const auto& o : outcomes) {
    result.keep_out_moves += o.count;
    if (o.depth > result.keep_out_depth) {
      result.keep_out_depth = o.depth;
      result.keep_out_at = moves[o.move].b;
      result.keep_out_line = moves[o.move].line;
    }
  }
}

} // namespace pointmill
