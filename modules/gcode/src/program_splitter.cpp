// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "program_splitter.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <string>

namespace pointmill::gcode {

namespace {

/// Lines that may come between two looks at the length: a tool change, or the longest
/// block, and the end of the program with the lift before it.
std::size_t reserveOf(const Post& post)
{
  const auto retract = std::max(post.retract_machine.size(), post.retract_home.size());
  const auto change = std::max(post.tool_change.size(), post.tool_pause.size()) +
                      post.coolant_on.size() + post.approach.size();
  constexpr std::size_t comments = 8, block = 3, lift = 1;
  return comments + 2 * (post.stop.size() + retract) + change + block + lift +
         post.end.size();
}

} // namespace

ProgramSplitter::ProgramSplitter(ProgramFiles& next,
                                 const Post& post,
                                 const Settings& settings)
    : CallAdapter(next), files_(next), settings_(settings), reserve_(reserveOf(post))
{
}

bool ProgramSplitter::isFull() const
{
  return files_.linesOfThis() + reserve_ > settings_.max_lines;
}

bool ProgramSplitter::isLong() const
{
  return 4 * (files_.linesOfThis() + reserve_) > 3 * settings_.max_lines;
}

void ProgramSplitter::begin(const ProgramHead& head)
{
  head_ = head;
  tool_ = 0;
  coolant_ = false;
  CallAdapter::begin(head);
}

void ProgramSplitter::operation(std::size_t number, const std::string& name)
{
  operation_ = number;
  operation_name_ = name;
  CallAdapter::operation(number, name);
}

void ProgramSplitter::changeTool(int number)
{
  tool_ = number;
  coolant_ = false;
  CallAdapter::changeTool(number);
}

void ProgramSplitter::spindle(long rpm)
{
  rpm_ = rpm;
  CallAdapter::spindle(rpm);
}

void ProgramSplitter::coolant(bool on)
{
  coolant_ = on;
  CallAdapter::coolant(on);
}

void ProgramSplitter::approach(const MachinePosition& to)
{
  at_ = to;
  CallAdapter::approach(to);
}

void ProgramSplitter::traverse(const MachinePosition& to)
{
  const bool high = std::min(at_.z, to.z) >= settings_.clearance;
  if (high && isLong()) {
    close();
    reopen(to);
  }
  else
    CallAdapter::traverse(to);
  at_ = to;
}

void ProgramSplitter::straight(const MachinePosition& to, std::int64_t feed)
{
  if (isFull())
    interrupt(feed);
  CallAdapter::straight(to, feed);
  at_ = to;
}

void ProgramSplitter::arc(const MachineArc& arc, std::int64_t feed)
{
  if (isFull())
    interrupt(feed);
  CallAdapter::arc(arc, feed);
  at_ = arc.to;
}

void ProgramSplitter::close()
{
  CallAdapter::stop();
  CallAdapter::retract();
  CallAdapter::end();
}

void ProgramSplitter::reopen(const MachinePosition& first)
{
  CallAdapter::begin(head_);
  CallAdapter::operation(operation_, operation_name_);
  CallAdapter::stop();
  CallAdapter::retract();
  CallAdapter::changeTool(tool_);
  CallAdapter::spindle(rpm_);
  if (coolant_)
    CallAdapter::coolant(true);
  CallAdapter::approach(first);
  if (isLong())
    throw ParameterError("GCodeWriter: max_lines is " +
                         std::to_string(settings_.max_lines) + "; head and end of a " +
                         "program take " +
                         std::to_string(files_.linesOfThis() + reserve_));
}

void ProgramSplitter::interrupt(std::int64_t feed)
{
  const auto above = [this](std::int64_t z) {
    return MachinePosition{at_.x, at_.y, std::max(at_.z, z)};
  };
  const auto clear = above(settings_.clearance);
  if (!(clear == at_))
    CallAdapter::traverse(clear);
  close();
  reopen(clear);
  const auto landing =
      above(std::min(settings_.clearance, at_.z + settings_.soft_landing));
  if (!(landing == clear))
    CallAdapter::traverse(landing);
  if (!(landing == at_))
    CallAdapter::straight(at_, feed);
}

} // namespace pointmill::gcode
