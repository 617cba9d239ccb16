// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "machine_state.h"

#include "operation_comment.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

MachineState::MachineState(Program& program,
                           const GCodeReader::MoveHandler& handler,
                           double chord_error,
                           int mounted_tool)
    : program_(program), handler_(handler), chord_error_(chord_error),
      tool_(mounted_tool), tool_known_(mounted_tool != 0), length_(mounted_tool != 0)
{
}

void MachineState::comment(std::string_view text)
{
  if (const auto name = operationName(text))
    beginSection(*name, true);
}

/// Comment and tool change, in either order and with rapids alone between them, begin
/// one section.
void MachineState::beginSection(std::string_view name, bool by_comment)
{
  const bool goes_on =
      !section_cut_ && (by_comment ? section_tooled_ && !section_named_
                                   : section_named_ && !section_tooled_);
  if (!goes_on) {
    program_.sections.push_back({{}, tool_, line_, moves_});
    section_named_ = section_tooled_ = section_cut_ = false;
  }
  auto& section = program_.sections.back();
  section.tool = tool_;
  if (by_comment)
    section.name = name;
  (by_comment ? section_named_ : section_tooled_) = true;
}

void MachineState::selectOffset(const std::string& name)
{
  offset_ = name;
  in_part_frame_ = framed_ && name == part_offset_;
}

void MachineState::fixFrame(Place place, const char* offset)
{
  if (framed_)
    refuse(place,
           "a position in " + offset_ + " after those in " +
               (part_offset_.empty() ? "the control's own frame" : part_offset_) +
               ": only one work offset is supported");
  part_offset_ = offset_.empty() ? offset : offset_;
  framed_ = in_part_frame_ = true;
}

void MachineState::shiftFrame(int axis, double value, Place place)
{
  if (!framed_) {
    // The frame of the first move is that of the part, whatever it is shifted by.
    at_[axis] = value;
    shifted_at_first_ = true;
    return;
  }
  if (!std::isfinite(at_[axis]))
    refuse(place, "G92 at an unknown position");
  shift_[axis] = at_[axis] - value;
  shift_rests_ = false;
}

void MachineState::dropShift(bool for_good, Place place)
{
  if (shifted_at_first_) {
    if (framed_)
      refuse(place,
             "the part's frame is that of G92: where the one without is, is unknown");
    at_.setConstant(unknown);
    shifted_at_first_ = false;
  }
  if (!shift_rests_)
    resting_shift_ = shift_;
  shift_rests_ = !for_good;
  shift_.setZero();
}

void MachineState::resumeShift(Place place)
{
  if (!shift_rests_)
    refuse(place, "G92.3 without a G92.2 before it");
  shift_ = resting_shift_;
  shift_rests_ = false;
}

void MachineState::changeTool(int number, bool length)
{
  tool_ = number;
  tool_known_ = true;
  program_.tools.push_back(number);
  turning_ = 0;
  length_ = length;
  // The machine may have gone to its place for tool changes.
  at_.x() = at_.y() = unknown;
  loseLength();
  beginSection({}, false);
}

void MachineState::setLength(bool in_force)
{
  length_ = in_force;
  loseLength();
}

/// The tip's Z after another tool or offset is unknown, unless it is above all.
void MachineState::loseLength()
{
  if (at_.z() != unbounded)
    at_.z() = unknown;
}

void MachineState::setPath(double blend, double merge)
{
  path_stated_ = true;
  if (!path_left_)
    program_.blend = std::max(program_.blend, blend);
  program_.merge = std::max(program_.merge, merge);
}

void MachineState::refuseFeedMove(const char* word, Place place) const
{
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(at_[axis]))
      refuse(place,
             std::string(word) + " from an unknown position: " +
                 static_cast<char>('X' + axis) + " is not set");
  refuse(place, std::string(word) + " without a feed: no F so far");
}

void MachineState::arc(const Arc& arc, double feed, Place place)
{
  const double a = arc.startRadius(), b = arc.endRadius(), off = std::abs(a - b);
  if (!(std::min(a, b) > 1e-6))
    refuse(place, "the arc's radius is 0");
  // Grbl's rule, the strictest one known.
  if (off > 0.5 || (off > 0.005 && off > 0.001 * a))
    refuse(place,
           "the arc's radius is " + std::to_string(a) + " mm at its start and " +
               std::to_string(b) + " mm at its end");
  const std::size_t n = arc.chords(chord_error_);
  for (std::size_t i = 1; i <= n; ++i)
    emit(arc.point(i, n), false, feed);
}

void MachineState::toMachinePlace(bool x, bool y, bool z, double height)
{
  Eigen::Vector3d to = at_;
  if (x)
    to.x() = unknown;
  if (y)
    to.y() = unknown;
  if (z)
    to.z() = height;
  emit(to, true, 0.0);
}

void MachineState::emit(const Eigen::Vector3d& to, bool rapid, double feed)
{
  ProgramMove m;
  m.from = at_;
  m.to = to;
  m.feed = feed;
  m.spindle = turning_ == 0 ? 0.0 : turning_ * speed_;
  m.line = line_;
  m.tool = tool_;
  m.rapid = rapid;
  m.from_known = at_.allFinite();
  m.length_offset = length_;
  handler_(m);
  at_ = to;
  ++moves_;
  if (rapid)
    return;
  has_cut_ = section_cut_ = true;
  if (!path_stated_ && !path_left_) {
    path_left_ = true;
    program_.blend = -1.0;
  }
}

} // namespace pointmill::gcode
