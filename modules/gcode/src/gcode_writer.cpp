// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "linuxcnc_printer.h"

#include <pointmill/common/error.h>
#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/gcode_writer.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

using namespace gcode;

namespace {

constexpr double farthest = 1e5; // mm

/// What the program has done so far, and what it may do next.
class Plan {
public:
  Plan(const std::vector<Operation>& operations,
       const GCodeWriter& settings,
       MachineCalls& calls)
      : operations_(operations), calls_(calls), grid_(settings.getDecimals()),
        clearance_(grid_.atOrAbove(static_cast<float>(settings.getClearancePlane()))),
        low_rapids_(settings.getLowRapids())
  {
  }

  GCodeWriter::Statistics run(ProgramHead head)
  {
    if (operations_.empty())
      throw DataError("GCodeWriter: there are no operations");
    for (index_ = 0; index_ < operations_.size(); ++index_) {
      checkOperation();
      addTool(head.tools, operations_[index_].tool);
    }
    calls_.begin(head);
    for (index_ = 0; index_ < operations_.size(); ++index_)
      runOperation();
    calls_.stop();
    retract();
    calls_.end();
    return statistics_;
  }

private:
  std::string where() const
  {
    return "GCodeWriter: operation " + std::to_string(index_ + 1) + " '" +
           operations_[index_].name + "'";
  }

  [[noreturn]] void refuse(std::size_t point, const std::string& why) const
  {
    throw DataError(where() + ", point " + std::to_string(point) + ": " + why);
  }

  void checkOperation() const
  {
    const auto& operation = operations_[index_];
    operation.tool.validate();
    checkRange(where(), "spindle", operation.cutting.spindle, "rev/min", {1, 1e6});
    if (operation.path.empty())
      throw DataError(where() + ": its path is empty");
  }

  void addTool(std::vector<Tool>& tools, const Tool& tool) const
  {
    for (const auto& known : tools) {
      if (known.number != tool.number)
        continue;
      if (known.diameter != tool.diameter ||
          known.corner_radius != tool.corner_radius ||
          known.flute_length != tool.flute_length || known.taper != tool.taper ||
          known.tip_diameter != tool.tip_diameter)
        throw ParameterError(where() + ": " + tool.describe() + " and " +
                             known.describe() + " differ but share one number");
      return;
    }
    tools.push_back(tool);
  }

  MachinePosition position(std::size_t i) const
  {
    const auto& p = operations_[index_].path[i];
    // Written so that NaN fails too.
    if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest &&
          std::abs(p.z) <= farthest))
      refuse(i, "a coordinate is not finite or beyond 100 m");
    return {grid_.nearest(p.x), grid_.nearest(p.y), grid_.atOrAbove(p.z)};
  }

  std::int64_t feed(std::size_t i) const
  {
    const double value = operations_[index_].path[i].feed;
    if (!(value >= 0.001 && value <= 1e6))
      throw ParameterError(where() + ", point " + std::to_string(i) + ": feed is " +
                           std::to_string(value) +
                           " mm/min; it must lie in 0.001 .. 1000000 mm/min");
    return feed_grid_.nearest(value);
  }

  void runOperation()
  {
    const auto& operation = operations_[index_];
    const auto last = operation.path.size() - 1;
    const auto first = position(0);
    if (first.z < clearance_)
      refuse(0, "the path begins below the clearance plane");
    if (position(last).z < clearance_)
      refuse(last, "the path ends below the clearance plane");

    calls_.comment("Operation " + std::to_string(index_ + 1) + ": " + operation.name);
    if (index_ == 0 || operation.tool.number != operations_[index_ - 1].tool.number)
      startTool(operation, first);
    else
      continueTool(operation, first);
    for (std::size_t i = 1; i <= last; ++i)
      runPoint(i);
  }

  void startTool(const Operation& operation, const MachinePosition& first)
  {
    calls_.stop();
    retract();
    calls_.changeTool(operation.tool.number);
    ++statistics_.tool_changes;
    spindle_ = std::lround(operation.cutting.spindle);
    calls_.spindle(spindle_);
    coolant_ = operation.cutting.coolant;
    if (coolant_)
      calls_.coolant(true);
    calls_.approach(first);
    statistics_.rapids += 2;
    at_ = first;
  }

  void continueTool(const Operation& operation, const MachinePosition& first)
  {
    const long spindle = std::lround(operation.cutting.spindle);
    if (spindle != spindle_)
      calls_.spindle(spindle_ = spindle);
    if (operation.cutting.coolant != coolant_)
      calls_.coolant(coolant_ = operation.cutting.coolant);
    const auto top = std::max(at_.z, first.z);
    if (!at_.sameColumn(first)) {
      traverse({at_.x, at_.y, top});
      traverse({first.x, first.y, top});
    }
    traverse(first);
  }

  void runPoint(std::size_t i)
  {
    const auto to = position(i);
    switch (operations_[index_].path[i].getMotion()) {
    case Motion::Rapid:
    case Motion::Retract:
      if (!to.sameColumn(at_)) {
        if (to.z != at_.z)
          refuse(i, "a rapid moves sideways and in Z at once");
        if (to.z < clearance_ && !low_rapids_)
          refuse(i, "a rapid moves sideways below the clearance plane");
      }
      if (to == at_)
        ++statistics_.skipped;
      else
        traverse(to);
      return;
    case Motion::Plunge:
    case Motion::Ramp:
    case Motion::LeadIn:
    case Motion::Cut:
    case Motion::LeadOut:
    case Motion::Link:
      break;
    default:
      refuse(i, "its motion is unknown");
    }
    const auto rate = feed(i);
    if (to == at_) {
      ++statistics_.skipped;
      return;
    }
    calls_.straight(to, rate);
    ++statistics_.feed_moves;
    at_ = to;
  }

  void traverse(const MachinePosition& to)
  {
    if (to == at_)
      return;
    calls_.traverse(to);
    ++statistics_.rapids;
    at_ = to;
  }

  void retract()
  {
    calls_.retract();
    ++statistics_.rapids;
  }

  const std::vector<Operation>& operations_;
  MachineCalls& calls_;
  DecimalGrid grid_;
  DecimalGrid feed_grid_{3};
  std::int64_t clearance_;
  bool low_rapids_;
  std::size_t index_ = 0;
  MachinePosition at_;
  long spindle_ = 0;
  bool coolant_ = false;
  GCodeWriter::Statistics statistics_;
};

} // namespace

GCodeWriter::Statistics GCodeWriter::write(const std::vector<Operation>& operations,
                                           MachineCalls& calls) const
{
  validateParameters(*this, "GCodeWriter");
  ProgramHead head;
  head.comments = comments_;
  head.path_tolerance = tolerance_;
  // A dry run finds every refusal before the first call.
  MachineCalls nothing;
  Plan(operations, *this, nothing).run(head);
  return Plan(operations, *this, calls).run(head);
}

GCodeWriter::Statistics GCodeWriter::write(const std::vector<Operation>& operations,
                                           std::ostream& out) const
{
  validateParameters(*this, "GCodeWriter");
  LinuxCncPrinter printer(out, decimals_);
  auto statistics = write(operations, printer);
  statistics.lines = printer.lines().lines();
  statistics.bytes = printer.lines().bytes();
  return statistics;
}

} // namespace pointmill
