// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "siemens_form.h"

namespace pointmill::gcode {

namespace {

constexpr int kCuttingEdge = 1; // the tool's first, the only one that is known

} // namespace

/// G4 F: seconds, G4 S: turns of the spindle.
void SiemensForm::dwell()
{
  const char word = block().firstOf("FS");
  if (!word || block().take(word) < 0)
    fail(code(NonModal)->column, "G4 needs F or S, at least 0");
}

/// G70 turns coordinates into inches, but leaves F in the unit of the machine, which
/// the program does not say; with G71 it is taken to be metric.
double SiemensForm::feedUnit(bool inches) const
{
  return !inches ? 1.0 : is(Units, 7000) ? inch : 0.0;
}

void SiemensForm::setTool()
{
  if (block().open('T'))
    next_tool_ = whole('T', 0, 999999);
  if (!code(ToolChange))
    return;
  if (next_tool_ < 0)
    fail(code(ToolChange)->column, "M6 without a T word");
  machine_.changeTool(next_tool_, offset_number_ == kCuttingEdge);
}

/// D n puts the length of a tool's cutting edge n in force. Beside a move of the
/// machine's frame it counts behind the move.
void SiemensForm::setLength()
{
  if (block().open('D') && !is(NonModal, 530) && !is(NonModal, 1530))
    applyOffsetNumber();
}

void SiemensForm::applyOffsetNumber()
{
  offset_number_ = whole('D', 0, 12);
  machine_.setLength(offset_number_ == kCuttingEdge);
}

void SiemensForm::setPath()
{
  bool says = code(PathMode);
  if (code(PathMode))
    switch (code(PathMode)->tenths) {
    case 600:
      corners_ = Corners::Exact;
      break;
    case 640:
      corners_ = Corners::Free;
      break;
    case 6410:
      corners_ = Corners::Distance;
      break;
    default:
      corners_ = Corners::Tolerance;
    }
  const auto read = [&](char word, double& value) {
    if (!block().open(word))
      return;
    value = length(word);
    if (value < 0)
      fail(word, wordName(word) + " must not be negative");
    says = true;
  };
  read(Block::Tolerance, tolerance_);
  read(Block::Rounding, distance_);
  if (block().open(Block::HighSpeed)) {
    // The cycle selects a path mode of its own, within its tolerance.
    read(Block::HighSpeed, tolerance_);
    corners_ = tolerance_ > 0 ? Corners::Tolerance : Corners::NotSaid;
  }
  if (says)
    statePath();
}

void SiemensForm::statePath()
{
  if (corners_ == Corners::Exact)
    machine_.setPath(0.0, 0.0);
  else if (corners_ == Corners::Free)
    machine_.setPath(unbounded, 0.0);
  else if (corners_ == Corners::Tolerance && tolerance_ > 0)
    machine_.setPath(tolerance_, 0.0);
  else if (corners_ == Corners::Distance)
    machine_.setPath(distance_, 0.0);
  else
    machine_.leavePath();
}

void SiemensForm::obeyNonModal()
{
  const Code& word = *code(NonModal);
  if (word.tenths == 40)
    return;
  if (!inRapid())
    fail(word.column, "machine coordinates are supported with G0 only");
  if (incremental())
    fail(word.column, "machine coordinates in incremental mode, G91");
  if (!block().firstOf("XYZ"))
    fail(word.column, "machine coordinates without X, Y or Z");
  moveInMachine(unbounded);
  if (block().open('D'))
    applyOffsetNumber();
}

} // namespace pointmill::gcode
