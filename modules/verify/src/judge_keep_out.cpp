// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"
#include "tool_bodies.h"

#include <pointmill/common/parallel.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr std::size_t kBatch = 4096; // moves at once for a thread

/// The cutter, and its shank and holder, each so high above the tip.
using Outline = std::pair<double, CutterProfile>;
std::vector<Outline> outlinesOf(const Tool& tool)
{
  std::vector<Outline> outlines{{0.0, tool.profile()}};
  for (const auto& body : bodiesOf(tool))
    outlines.emplace_back(body.above, body.asTool().profile());
  return outlines;
}

} // namespace

void judgeKeepOut(const KeepOut& keep_out,
                  const std::vector<SweptMove>& moves,
                  double tolerance,
                  unsigned threads,
                  Verification& result,
                  Findings& findings)
{
  if (keep_out.empty())
    return;
  std::map<const Tool*, std::vector<Outline>> outlines;
  for (const auto& m : moves)
    if (outlines.find(m.tool) == outlines.end())
      outlines.emplace(m.tool, outlinesOf(*m.tool));

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
      double depth = 0;
      for (const auto& [above, cutter] : outlines.at(m.tool)) {
        const Eigen::Vector3d up(0, 0, above), a = m.a + up, b = m.b + up;
        depth = std::max(depth,
                         m.mayBend()
                             ? keep_out.depthIn(cutter, a.cwiseMin(b), a.cwiseMax(b))
                             : keep_out.depth(cutter, a, b));
      }
      mine.count += depth > tolerance;
      if (depth > mine.depth) {
        mine.depth = depth;
        mine.move = k;
      }
    }
  });

  int tool = 0;
  for (const auto& o : outcomes) {
    result.keep_out_moves += o.count;
    if (o.depth > result.keep_out_depth) {
      result.keep_out_depth = o.depth;
      result.keep_out_at = moves[o.move].b;
      result.keep_out_line = moves[o.move].line;
      tool = moves[o.move].tool->number;
    }
  }
  if (result.keep_out_moves > 0)
    findings.add("keep_out",
                 result.keep_out_depth,
                 result.keep_out_at,
                 result.keep_out_line,
                 tool,
                 result.keep_out_moves);
}

} // namespace pointmill
