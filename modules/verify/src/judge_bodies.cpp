// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"
#include "tool_bodies.h"

#include <pointmill/common/parallel.h>

#include <algorithm>
#include <deque>

namespace pointmill {
namespace {

/// How deep points get into a tool whose tip may be anywhere between `low` and `high`.
double depthInBox(const PointIndex& part,
                  const CutterProfile& cutter,
                  const Eigen::Vector3d& low,
                  const Eigen::Vector3d& high)
{
  const double r = cutter.radius();
  if (low.x() - r > part.max().x() || high.x() + r < part.min().x() ||
      low.y() - r > part.max().y() || high.y() + r < part.min().y())
    return 0;
  const int c0 = part.columnOf(low.x() - r), c1 = part.columnOf(high.x() + r);
  const int r1 = part.rowOf(high.y() + r);
  double deepest = 0;
  for (int row = part.rowOf(low.y() - r); row <= r1; ++row) {
    const auto [first, last] = part.cells(row, c0, c1);
    for (std::size_t i = first; i < last; ++i) {
      const Eigen::Vector3d p = part.point(i);
      if (p.z() <= low.z())
        continue;
      const double dx = std::max({0.0, low.x() - p.x(), p.x() - high.x()});
      const double dy = std::max({0.0, low.y() - p.y(), p.y() - high.y()});
      deepest = std::max(deepest,
                         cutter.depth(std::sqrt(dx * dx + dy * dy), p.z() - low.z()));
    }
  }
  return deepest;
}

} // namespace

void judgeBends(const PointIndex& part,
                const std::vector<SweptMove>& moves,
                double tolerance,
                unsigned threads,
                Findings& findings)
{
  // The cutter, its shank and its holder: each that comes low enough.
  struct Bend {
    const SweptMove* move;
    const char* code;
    double above;
    CutterProfile profile;
    double depth = 0;
  };
  std::vector<Bend> bends;
  for (const auto& m : moves) {
    const double lowest = std::min(m.a.z(), m.b.z()) + tolerance;
    if (!m.mayBend() || lowest >= part.max().z())
      continue;
    bends.push_back({&m, "rapid_in_part", 0.0, m.tool->profile()});
    for (const auto& body : bodiesOf(*m.tool))
      if (lowest + body.above < part.max().z())
        bends.push_back({&m, body.code, body.above, body.asTool().profile()});
  }
  parallelFor(bends.size(), threads, [&](std::size_t i) {
    const SweptMove& m = *bends[i].move;
    const Eigen::Vector3d up(0, 0, bends[i].above);
    bends[i].depth = depthInBox(
        part, bends[i].profile, m.a.cwiseMin(m.b) + up, m.a.cwiseMax(m.b) + up);
  });
  for (const auto& bend : bends) {
    const SweptMove& m = *bend.move;
    if (bend.depth > tolerance)
      findings.add(bend.code, bend.depth, m.b, m.line, m.tool->number);
  }
}

void judgeBodies(const PointIndex& part,
                 const std::vector<SweptMove>& moves,
                 double tolerance,
                 unsigned threads,
                 Findings& findings)
{
  // A body is swept as a tool of its own, on the moves on which it gets low enough.
  struct Bodies {
    std::deque<Tool> tools;
    std::map<std::pair<const Tool*, double>, const Tool*> known;
    std::vector<SweptMove> moves;
  };
  std::map<std::string, Bodies> by_code;
  for (const auto& m : moves)
    for (const auto& body : bodiesOf(*m.tool)) {
      const Eigen::Vector3d up(0, 0, body.above);
      if (std::min(m.a.z(), m.b.z()) + body.above >= part.max().z() - tolerance)
        continue;
      Bodies& bodies = by_code[body.code];
      const Tool*& tool = bodies.known[{m.tool, body.above}];
      if (!tool) {
        bodies.tools.push_back(body.asTool());
        bodies.tools.back().number = m.tool->number;
        tool = &bodies.tools.back();
      }
      bodies.moves.push_back({m.a + up, m.b + up, tool, m.line, m.rapid});
    }
  for (const auto& [code, bodies] : by_code) {
    std::vector<float> height;
    const Gouges gouges = sweepPoints(part, bodies.moves, tolerance, threads, height);
    if (gouges.count > 0)
      findings.add(code.c_str(),
                   gouges.depth,
                   gouges.at,
                   gouges.line,
                   gouges.tool,
                   gouges.count);
  }
}

} // namespace pointmill
