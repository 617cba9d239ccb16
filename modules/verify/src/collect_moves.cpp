// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/watch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// No control takes more [mm/min], no spindle turns faster [rev/min].
constexpr double kAbsurdFeed = 1e5, kAbsurdSpindle = 2.5e5;
/// A chip thicker than this share of the diameter breaks any cutter: such a feed is a
/// slip of units.
constexpr double kAbsurdChip = 0.1;
/// More than this breaks the tool.
constexpr double kWrongChip = 0.25;
/// Slower is no feed [mm/min].
constexpr double kLeastFeed = 1.0;
/// More than what rounding takes from a height [mm].
constexpr double kRounding = 1e-3;
/// Of a tip at the top of the machine.
constexpr double kTop = std::numeric_limits<double>::infinity();

/// Whether X or Y moves while nobody knows how high the tool is.
bool sidewaysBlind(const ProgramMove& m)
{
  const auto stays = [&](int axis) {
    return m.from[axis] == m.to[axis] ||
           (std::isnan(m.from[axis]) && std::isnan(m.to[axis]));
  };
  return (!stays(0) || !stays(1)) && std::isnan(m.from.z());
}

/// Takes the moves of a program one after the other.
class MoveCollector {
public:
  MoveCollector(const std::vector<Tool>& tools,
                const MoveLimits& limits,
                Verification& result,
                Findings& findings)
      : limits_(limits), result_(result), findings_(findings)
  {
    for (const auto& tool : tools)
      tools_[tool.number] = &tool;
  }

  /// The tool if the move can be swept, else nullptr.
  const Tool* take(const ProgramMove& m)
  {
    checkToolChange(m);
    checkTravel(m);
    checkLength(m);
    const auto found = tools_.find(m.tool);
    const Tool* tool = found == tools_.end() ? nullptr : found->second;
    const bool known = m.from.allFinite() && m.to.allFinite();
    if (!tool)
      checkWithoutTool(m);
    else if (!known)
      checkUnknown(m);
    else
      checkKnown(m, *tool);
    before_ = &m;
    return known ? tool : nullptr;
  }

  void end(const Program& program)
  {
    if (!program.ended)
      findings_.add("not_ended");
    if (before_ && before_->to.z() < limits_.safe)
      find("unsafe_end", limits_.safe - before_->to.z(), *before_);
  }

private:
  void find(const char* code, double worst, const ProgramMove& m)
  {
    findings_.add(code, worst, m.to, m.line, m.tool);
  }

  /// A change takes place where the last move ended, unless the machine goes elsewhere
  /// of itself.
  void checkToolChange(const ProgramMove& m)
  {
    if (before_ && before_->tool != 0 && before_->to.z() < limits_.safe &&
        (m.tool != before_->tool || std::isnan(m.from.z())))
      find("unsafe_tool_change", limits_.safe - before_->to.z(), *before_);
  }

  /// In the part frame Z means nothing without the tool's length, in rapids neither.
  void checkLength(const ProgramMove& m)
  {
    if (m.tool != 0 && !m.length_offset && std::isfinite(m.to.z()) &&
        m.to.z() != m.from.z())
      find("length_offset", 0, m);
  }

  void checkTravel(const ProgramMove& m)
  {
    if (!limits_.machine.travel)
      return;
    const Stock& travel = *limits_.machine.travel;
    double beyond = 0;
    for (const auto& p : {m.from, m.to})
      for (int axis = 0; axis < 3; ++axis)
        if (std::isfinite(p[axis]))
          beyond = std::max(
              {beyond, travel.min[axis] - p[axis], p[axis] - travel.max[axis]});
    if (beyond > kRounding)
      find("outside_travel", beyond, m);
  }

  void checkWithoutTool(const ProgramMove& m)
  {
    if (!m.rapid)
      find("unknown_tool", 0, m);
    // The spindle may be empty before the first tool change, but it must be high up.
    else if (m.from.z() < limits_.safe || m.to.z() < limits_.safe)
      find("no_tool_below_stock", 0, m);
    else if (sidewaysBlind(m))
      find("unknown_position", 0, m);
  }

  /// Where the machine stands is not known: only Z may move, high up, or from anywhere
  /// to the top of the machine.
  void checkUnknown(const ProgramMove& m)
  {
    const bool high = !(m.from.z() < limits_.safe) && !(m.to.z() < limits_.safe);
    const bool lift = m.to.z() == kTop && m.from.head<2>() == m.to.head<2>();
    if (!m.rapid || (!high && !lift) || sidewaysBlind(m))
      find("unknown_position", 0, m);
  }

  void checkKnown(const ProgramMove& m, const Tool& tool)
  {
    const double lowest = std::min(m.from.z(), m.to.z());
    if (limits_.stock.min.z() - lowest > limits_.tolerance)
      find("below_stock", limits_.stock.min.z() - lowest, m);
    auto& tip = result_.lowest_tip.emplace(m.tool, lowest).first->second;
    tip = std::min(tip, lowest);
    if (!m.rapid)
      checkFeed(m, tool);
  }

  void checkFeed(const ProgramMove& m, const Tool& tool)
  {
    const Machine& machine = limits_.machine;
    if (!(m.feed >= kLeastFeed) || m.feed > kAbsurdFeed)
      find("feed", m.feed, m);
    else if (machine.max_feed > 0 && m.feed > machine.max_feed + kRounding)
      find("feed_limit", m.feed, m);
    if (!m.length_offset)
      find("length_offset", 0, m);
    if (!(m.spindle > 0) || m.spindle > kAbsurdSpindle) {
      find("spindle", m.spindle, m);
      return;
    }
    const double slow = machine.min_spindle - m.spindle;
    const double fast = machine.max_spindle > 0 ? m.spindle - machine.max_spindle : 0;
    if (std::max(slow, fast) > kRounding)
      find("spindle_limit", std::max(slow, fast), m);
    const double chip = m.feed / (m.spindle * tool.flutes);
    if (chip > kWrongChip * tool.diameter)
      find("feed", m.feed, m);
    else if (chip > kAbsurdChip * tool.diameter)
      find("chip_load", chip, m);
    if (before_ && !before_->rapid && before_->tool == m.tool &&
        before_->spindle != m.spindle)
      find("spindle_change", std::abs(m.spindle - before_->spindle), m);
  }

  const MoveLimits& limits_;
  Verification& result_;
  Findings& findings_;
  std::map<int, const Tool*> tools_;
  const ProgramMove* before_ = nullptr;
};

void measure(const ProgramMove& m, SectionFigures& section)
{
  ++(m.rapid ? section.rapid_moves : section.feed_moves);
  const double length = (m.to - m.from).norm();
  if (std::isfinite(length))
    (m.rapid ? section.rapid_length : section.feed_length) += length;
}

} // namespace

std::vector<SweptMove> collectMoves(const Program& program,
                                    const std::vector<Tool>& tools,
                                    const MoveLimits& limits,
                                    Verification& result,
                                    Findings& findings)
{
  const auto sections = sectionsOf(program);
  for (const auto& s : sections) {
    result.sections.emplace_back();
    result.sections.back().name = s.name;
    result.sections.back().tool = s.tool;
    result.sections.back().line = s.line;
  }

  MoveCollector collector(tools, limits, result, findings);
  std::vector<SweptMove> moves;
  moves.reserve(program.moves.size());
  std::uint32_t section = 0;
  for (std::size_t k = 0; k < program.moves.size(); ++k) {
    if (k % 4096 == 0)
      checkInterrupted();
    const ProgramMove& m = program.moves[k];
    while (section + 1 < sections.size() && sections[section + 1].move <= k)
      ++section;
    measure(m, result.sections[section]);
    if (const Tool* tool = collector.take(m))
      moves.push_back({m.from, m.to, tool, m.line, m.rapid, section});
  }
  collector.end(program);
  for (const auto& s : result.sections) {
    result.feed_moves += s.feed_moves;
    result.rapid_moves += s.rapid_moves;
    result.feed_length += s.feed_length;
    result.rapid_length += s.rapid_length;
  }
  return moves;
}

} // namespace pointmill
