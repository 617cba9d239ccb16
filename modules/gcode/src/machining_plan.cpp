// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "machining_plan.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

constexpr double farthest = 1e5; // mm

bool isSame(const Tool& a, const Tool& b)
{
  return a.diameter == b.diameter && a.corner_radius == b.corner_radius &&
         a.flute_length == b.flute_length && a.taper == b.taper &&
         a.tip_diameter == b.tip_diameter;
}

} // namespace

MachiningPlan::MachiningPlan(const std::vector<Operation>& operations,
                             const GCodeWriter& settings)
    : operations_(operations), grid_(settings.getGrid()),
      clearance_(grid_.atOrAbove(static_cast<float>(settings.getClearancePlane()))),
      low_rapids_(settings.getLowRapids()),
      one_tool_(settings.getToolChange() == ToolChange::Program),
      retracts_(settings.getRetract() != Retract::Clearance),
      speeds_alone_(!settings.getPost().spindle.empty())
{
  if (operations_.empty())
    throw DataError("GCodeWriter: there are no operations");
}

bool MachiningPlan::hasSameTool(std::size_t index) const
{
  return index > 0 &&
         operations_[index].tool.number == operations_[index - 1].tool.number;
}

std::vector<MachiningPlan::Part> MachiningPlan::parts() const
{
  std::vector<Part> parts;
  for (std::size_t i = 0; i < operations_.size(); ++i) {
    if (parts.empty() || (one_tool_ && !hasSameTool(i)))
      parts.push_back({i, i});
    parts.back().last = i + 1;
  }
  return parts;
}

GCodeWriter::Statistics MachiningPlan::run(const ProgramHead& head, MachineCalls& calls)
{
  statistics_ = {};
  calls_ = &calls;
  toolsOf({0, operations_.size()}); // over all programs each number is one tool
  for (const auto& part : parts()) {
    ProgramHead own = head;
    own.tools = toolsOf(part);
    calls.begin(own);
    runPart(part);
    calls.end();
  }
  return statistics_;
}

void MachiningPlan::runPart(const Part& part)
{
  for (index_ = part.first; index_ < part.last; ++index_)
    runOperation(index_ == part.first);
  calls_->stop();
  retract();
}

/// The tools in the order of their first use.
std::vector<Tool> MachiningPlan::toolsOf(const Part& part)
{
  std::vector<Tool> tools;
  for (index_ = part.first; index_ < part.last; ++index_) {
    const auto& tool = operations_[index_].tool;
    tool.validate();
    const auto known =
        std::find_if(tools.begin(), tools.end(), [&tool](const Tool& other) {
          return other.number == tool.number;
        });
    if (known == tools.end())
      tools.push_back(tool);
    else if (!isSame(*known, tool))
      throw ParameterError(where() + ": " + tool.describe() + " and " +
                           known->describe() + " differ but share one number");
  }
  return tools;
}

std::string MachiningPlan::where() const
{
  return "GCodeWriter: operation " + std::to_string(index_ + 1) + " '" +
         operations_[index_].name + "'";
}

void MachiningPlan::refuse(std::size_t point, const std::string& why) const
{
  throw DataError(where() + ", point " + std::to_string(point) + ": " + why);
}

void MachiningPlan::checkOperation() const
{
  const auto& operation = operations_[index_];
  checkRange(where(), "spindle", operation.cutting.spindle, "rev/min", {1, 1e6});
  if (operation.path.empty())
    throw DataError(where() + ": its path is empty");
}

MachinePosition MachiningPlan::position(std::size_t i) const
{
  const auto& p = operations_[index_].path[i];
  // Written so that NaN fails too.
  if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest &&
        std::abs(p.z) <= farthest))
    refuse(i, "a coordinate is not finite or beyond 100 m");
  return {grid_.nearest(p.x), grid_.nearest(p.y), grid_.atOrAbove(p.z)};
}

std::int64_t MachiningPlan::feed(std::size_t i) const
{
  const double value = operations_[index_].path[i].feed;
  if (!(value >= 0.001 && value <= 1e6))
    throw ParameterError(where() + ", point " + std::to_string(i) + ": feed is " +
                         std::to_string(value) +
                         " mm/min; it must lie in 0.001 .. 1000000 mm/min");
  return feed_grid_.nearest(value);
}

void MachiningPlan::runOperation(bool first_of_program)
{
  checkOperation();
  const auto& operation = operations_[index_];
  const auto last = operation.path.size() - 1;
  const auto first = position(0);
  if (first.z < clearance_)
    refuse(0, "the path begins below the clearance plane");
  if (position(last).z < clearance_)
    refuse(last, "the path ends below the clearance plane");

  calls_->operation(index_ + 1, operation.name);
  const bool new_speed = std::lround(operation.cutting.spindle) != spindle_;
  if (first_of_program || !hasSameTool(index_) || (new_speed && !speeds_alone_))
    startTool(operation, first);
  else
    continueTool(operation, first);
  for (std::size_t i = 1; i <= last; ++i) {
    checkInterrupted();
    runPoint(i);
  }
}

void MachiningPlan::startTool(const Operation& operation, const MachinePosition& first)
{
  calls_->stop();
  retract();
  calls_->changeTool(operation.tool.number);
  ++statistics_.tool_changes;
  spindle_ = std::lround(operation.cutting.spindle);
  calls_->spindle(spindle_);
  coolant_ = operation.cutting.coolant;
  if (coolant_)
    calls_->coolant(true);
  calls_->approach(first);
  statistics_.rapids += 2;
  at_ = first;
}

void MachiningPlan::continueTool(const Operation& operation,
                                 const MachinePosition& first)
{
  const long spindle = std::lround(operation.cutting.spindle);
  if (spindle != spindle_)
    calls_->spindle(spindle_ = spindle);
  if (operation.cutting.coolant != coolant_)
    calls_->coolant(coolant_ = operation.cutting.coolant);
  const auto top = std::max(at_.z, first.z);
  if (!at_.sameColumn(first)) {
    traverse({at_.x, at_.y, top});
    traverse({first.x, first.y, top});
  }
  traverse(first);
}

void MachiningPlan::runPoint(std::size_t i)
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
  calls_->straight(to, rate);
  ++statistics_.feed_moves;
  at_ = to;
}

void MachiningPlan::traverse(const MachinePosition& to)
{
  if (to == at_)
    return;
  calls_->traverse(to);
  ++statistics_.rapids;
  at_ = to;
}

void MachiningPlan::retract()
{
  calls_->retract();
  if (retracts_)
    ++statistics_.rapids;
}

} // namespace pointmill::gcode
