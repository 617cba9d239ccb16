// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

Bands::Bands(const std::vector<SweptMove>& moves, double y0, double height, int count)
    : bands_(static_cast<std::size_t>(std::max(1, count)))
{
  const auto band = [&](double y) {
    const double b = std::floor((y - y0) / height);
    return static_cast<int>(std::clamp(b, -1.0, bands_.size() * 1.0));
  };
  const int last = static_cast<int>(bands_.size()) - 1;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const auto& m = moves[k];
    const double r = m.tool->radius();
    // a hair more on both sides, for points sorted in float32
    const int first = band(std::min(m.a.y(), m.b.y()) - r - 1e-3 * height);
    const int end = band(std::max(m.a.y(), m.b.y()) + r + 1e-3 * height);
    for (int b = std::max(0, first); b <= std::min(last, end); ++b)
      bands_[static_cast<std::size_t>(b)].push_back(static_cast<std::uint32_t>(k));
  }
}

namespace {

/// Whether X or Y moves while nobody knows how high the tool is.
bool sidewaysBlind(const ProgramMove& m)
{
  const auto stays = [&](int axis) {
    return m.from[axis] == m.to[axis] ||
           (std::isnan(m.from[axis]) && std::isnan(m.to[axis]));
  };
  return (!stays(0) || !stays(1)) && std::isnan(m.from.z());
}

} // namespace

std::vector<SweptMove> collectMoves(const Program& program,
                                    const std::vector<Tool>& tools,
                                    const Stock& stock,
                                    double safe,
                                    Verification& result)
{
  std::map<int, const Tool*> by_number;
  for (const auto& tool : tools)
    by_number[tool.number] = &tool;
  // One finding of a kind, its first place: a wrong program repeats itself.
  const auto find =
      [&](const char* code, const std::string& text, const ProgramMove& m) {
        for (const auto& f : result.findings)
          if (f.code == code)
            return;
        result.findings.push_back({code, text, 0, m.to, m.line});
      };

  std::vector<SweptMove> moves;
  moves.reserve(program.moves.size());
  for (const auto& m : program.moves) {
    const double length = (m.to - m.from).norm();
    ++(m.rapid ? result.rapid_moves : result.feed_moves);
    if (std::isfinite(length))
      (m.rapid ? result.rapid_length : result.feed_length) += length;

    const auto tool = by_number.find(m.tool);
    if (tool == by_number.end()) {
      if (!m.rapid)
        find("unknown_tool",
             "feed move with tool " + std::to_string(m.tool) + ", which is not known",
             m);
      // The spindle may be empty before the first tool change, but it must be high up.
      else if (m.from.z() < safe || m.to.z() < safe)
        find("no_tool_below_stock",
             "rapid below the top of the stock and of what is to be kept out of, "
             "without a tool",
             m);
      else if (sidewaysBlind(m))
        find("unknown_position", "sideways move at an unknown height", m);
      continue;
    }
    if (!m.from.allFinite() || !m.to.allFinite()) {
      // Where the machine stands is not known: only Z may move, high up.
      const bool high = !(m.from.z() < safe) && !(m.to.z() < safe);
      if (!m.rapid || !high || sidewaysBlind(m))
        find("unknown_position",
             "move from or to an unknown position that is not safely above the stock "
             "and all that is to be kept out of",
             m);
      continue;
    }
    if (!m.rapid) {
      if (!(m.feed > 0) || m.feed > 1e5)
        find("feed", "feed move without a sensible feed", m);
      if (!m.length_offset)
        find("length_offset", "feed move without the tool's length (G43)", m);
      if (std::min(m.from.z(), m.to.z()) < stock.min.z() - 1e-3)
        find("below_stock", "feed move below the bottom of the stock", m);
      if (!(m.spindle > 0))
        find("spindle", "feed move while the spindle stands or turns backwards", m);
    }
    auto& lowest = result.lowest_tip.emplace(m.tool, m.to.z()).first->second;
    lowest = std::min({lowest, m.from.z(), m.to.z()});
    moves.push_back({m.from, m.to, tool->second, m.line, m.rapid});
  }
  if (!program.ended)
    result.findings.push_back(
        {"no_end", "the program does not end with M2 or M30", 0, {0, 0, 0}, 0});
  if (result.feed_moves == 0)
    result.findings.push_back(
        {"cuts_nothing", "the program cuts nothing", 0, {0, 0, 0}, 0});
  return moves;
}

} // namespace pointmill
