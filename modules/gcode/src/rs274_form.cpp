// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "rs274_form.h"

#include <cmath>

namespace pointmill::gcode {

void Rs274Form::dwell()
{
  const char word = block().firstOf("PX"); // X is Fanuc's
  if (!word || block().take(word) < 0)
    fail(code(NonModal)->column, "G4 needs P, at least 0 seconds");
}

void Rs274Form::readTool()
{
  if (block().open('T'))
    next_tool_ = whole('T', 0, 999999);
}

void Rs274Form::setTool()
{
  readTool();
  if (!code(ToolChange))
    return;
  if (next_tool_ < 0)
    fail(code(ToolChange)->column, "M6 without a T word");
  machine_.changeTool(next_tool_, false);
}

void Rs274Form::setLength()
{
  if (!code(Length))
    return;
  const bool stated = is(Length, 430) && block().open('H');
  if (stated) {
    const int h = whole('H', 0, 999999);
    if (machine_.toolKnown() && h != machine_.tool())
      fail('H',
           "H" + std::to_string(h) + " is not the length of tool " +
               std::to_string(machine_.tool()));
  }
  // Without H LinuxCNC takes the tool's own length, Fanuc and Haas that of the tool
  // before.
  machine_.setLength(stated);
}

void Rs274Form::setOffset()
{
  const Code& word = *code(Offset);
  if (word.tenths != 541 && word.tenths != 1540) {
    WordForm::setOffset();
    return;
  }
  const std::string name = codeName('G', word.tenths);
  if (!block().open('P'))
    fail(word.column, name + " needs P");
  machine_.selectOffset(name + " P" + std::to_string(whole('P', 1, 300)));
}

void Rs274Form::setPath()
{
  if (!code(PathMode))
    return;
  double blend = 0.0, merge = 0.0;
  if (is(PathMode, 640)) {
    blend = merge = block().open('P') ? length('P') : unbounded;
    if (block().open('Q'))
      merge = length('Q');
    if (blend < 0 || merge < 0)
      fail(code(PathMode)->column, "G64 with a negative tolerance");
  }
  machine_.setPath(blend, merge);
}

void Rs274Form::obeyNonModal()
{
  const Code& word = *code(NonModal);
  switch (word.tenths) {
  case 51:
    // How far look-ahead may leave the path is a parameter of the machine.
    if (!block().open('Q') || block().firstOf("XYZIJK"))
      fail(word.column, "G5.1 (spline) is not supported");
    whole('Q', 0, 1);
    if (block().open('R'))
      whole('R', 1, 10);
    machine_.leavePath();
    break;
  case 1870:
    setSmoothness();
    break;
  case 280:
  case 300:
    returnHome(word.tenths == 280, word.column);
    break;
  case 530:
    moveInMachineFrame(word.column);
    break;
  case 920:
    shiftFrame(word.column);
    break;
  case 921:
    machine_.dropShift(true, place(word.column));
    break;
  case 922:
    machine_.dropShift(false, place(word.column));
    break;
  case 923:
    machine_.resumeShift(place(word.column));
    break;
  default:
    break;
  }
}

/// G187 P3 E0.05: so far may a corner be rounded; without E as the machine is set.
void Rs274Form::setSmoothness()
{
  if (block().open('P'))
    whole('P', 1, 3);
  if (!block().open('E')) {
    machine_.leavePath();
    return;
  }
  const double rounding = length('E');
  if (rounding < 0)
    fail('E', "E must not be negative");
  machine_.setPath(rounding, 0.0);
}

/// The block's axes are a non-modal word's; another motion would want them as well.
void Rs274Form::checkAlone(int column, const char* what) const
{
  if (code(MotionMode) && !is(MotionMode, 0))
    fail(column,
         std::string(what) + " beside " + codeName('G', code(MotionMode)->tenths));
}

void Rs274Form::moveInMachineFrame(int column)
{
  if (!inRapid())
    fail(column, "G53 is supported with G0 only");
  if (incremental())
    fail(column, "G53 in incremental mode, G91");
  if (!block().firstOf("XYZ"))
    fail(column, "G53 without X, Y or Z");
  moveInMachine(unbounded);
}

/// Through the block's point, then its axes, or all, to the reference point: of the
/// first one Z is the machine's top, a second one is wherever it was set.
void Rs274Form::returnHome(bool first_point, int column)
{
  checkAlone(column, first_point ? "G28" : "G30");
  if (!first_point && block().open('P'))
    whole('P', 2, 4);
  const bool x = block().open('X'), y = block().open('Y'), z = block().open('Z');
  const bool all = !x && !y && !z;
  const Eigen::Vector3d between = target(true), &at = machine_.at();
  bool stays = true;
  for (int axis = 0; axis < 3; ++axis)
    stays &= between[axis] == at[axis] || std::isnan(between[axis]);
  if (!stays)
    machine_.rapid(between);
  machine_.toMachinePlace(
      x || all, y || all, z || all, first_point ? unbounded : -unbounded);
}

void Rs274Form::shiftFrame(int column)
{
  checkAlone(column, "G92");
  if (!block().firstOf("XYZ"))
    fail(column, "G92 without X, Y or Z");
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = static_cast<char>('X' + axis);
    if (block().open(letter))
      machine_.shiftFrame(axis, length(letter), place(block().column(letter)));
  }
}

GrblForm::GrblForm(MachineState& machine) : Rs274Form(ProgramForm::Grbl, machine)
{
  machine_.setLength(true);
  machine_.setPath(0.0, 0.0);
}

void GrblForm::setTool()
{
  if (!block().open('T'))
    return;
  const int column = block().column('T');
  readTool();
  if (!machine_.hasCut())
    fit(column);
}

void GrblForm::checkTool(int column) const
{
  if (nextTool() >= 0 && nextTool() != machine_.tool())
    fail(column,
         "T" + std::to_string(nextTool()) + " is not fitted yet: there was no M0");
}

void GrblForm::pause()
{
  if (nextTool() >= 0 && nextTool() != machine_.tool() && is(Stop, 0))
    fit(code(Stop)->column);
}

void GrblForm::fit(int column)
{
  if (machine_.turns())
    fail(column, "T" + std::to_string(nextTool()) + " while the spindle turns");
  machine_.changeTool(nextTool(), true);
}

} // namespace pointmill::gcode
