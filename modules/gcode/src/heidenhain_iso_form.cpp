// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "heidenhain_iso_form.h"

#include "number.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

/// The text behind a leading N word and blanks.
std::string_view behindNumber(std::string_view text)
{
  const auto skip = [&text](auto is) {
    while (!text.empty() && is(text.front()))
      text.remove_prefix(1);
  };
  skip(isBlank);
  if (!text.empty() && upper(text.front()) == 'N') {
    text.remove_prefix(1);
    skip(isDigit);
    skip(isBlank);
  }
  return text;
}

} // namespace

bool HeidenhainIsoForm::obey(std::string_view text, std::size_t line)
{
  const std::string_view rest = behindNumber(text);
  if (!rest.empty() && rest.front() == '%')
    return readHead(text, line);
  if (!begun_ && !rest.empty() && rest.front() != ';')
    refuse({line, 1}, "the program must begin with '%', its name and G71 or G70");
  return WordForm::obey(text, line);
}

/// "%NAME G71" begins the program, and ends it.
bool HeidenhainIsoForm::readHead(std::string_view text, std::size_t line)
{
  if (begun_)
    return false;
  const auto column = [&](std::size_t at) { return static_cast<int>(at) + 1; };
  const std::size_t name = text.find('%') + 1;
  const std::size_t blank = text.find_first_of(" \t", name);
  if (blank == name || name == text.size())
    refuse({line, column(name)}, "the program's name is missing");
  const std::size_t unit = text.find_first_not_of(" \t", std::min(blank, text.size()));
  const std::string_view word =
      unit == std::string_view::npos ? std::string_view() : text.substr(unit, 3);
  if (word != "G70" && word != "G71")
    refuse({line, column(std::min(unit, text.size()))},
           "G71 or G70 must stand behind the program's name");
  const std::size_t end = text.find_first_not_of(" \t*\r", unit + 3);
  if (end != std::string_view::npos)
    refuse({line, column(end)}, shown(text[end]) + " behind the program's unit");
  setUnit(word == "G70");
  begun_ = true;
  return true;
}

void HeidenhainIsoForm::dwell()
{
  if (!block().open('F') || block().take('F') < 0)
    fail(code(NonModal)->column, "G04 needs F, at least 0 seconds");
}

void HeidenhainIsoForm::setTool()
{
  // G62 has a T of its own, and G51 only names the next tool.
  if (!block().open('T') || code(PathMode))
    return;
  const int number = whole('T', 0, 32767);
  if (!is(NonModal, 510))
    machine_.changeTool(number, number > 0);
}

void HeidenhainIsoForm::setPath()
{
  if (!code(PathMode))
    return;
  if (!block().open('T')) {
    machine_.leavePath();
    return;
  }
  const double tolerance = length('T');
  if (tolerance < 0)
    fail('T', "G62 with a negative tolerance");
  machine_.setPath(tolerance, 0.0);
}

void HeidenhainIsoForm::obeyNonModal()
{
  if (is(NonModal, 300) || is(NonModal, 310)) {
    // The blank is for the control's picture.
    for (const char axis : {'X', 'Y', 'Z'})
      if (block().open(axis))
        length(axis);
    return;
  }
  if (!code(MachineFrame))
    return;
  const int column = code(MachineFrame)->column;
  if (!inRapid())
    fail(column, "machine coordinates are supported with G00 only");
  if (incremental())
    fail(column, "machine coordinates in incremental mode, G91");
  if (!block().firstOf("XYZ"))
    fail(column, "machine coordinates without X, Y or Z");
  // M92 counts from a place that the machine's builder chose.
  moveInMachine(is(MachineFrame, 910) ? unbounded : unknown);
}

void HeidenhainIsoForm::setPole()
{
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = static_cast<char>('I' + axis);
    if (!block().open(letter))
      continue;
    const double value = length(letter);
    if (incremental() && !std::isfinite(machine_.at()[axis]))
      fail(letter, std::string("G91: ") + letter + " from an unknown position");
    pole_[axis] = incremental() ? machine_.at()[axis] + value : value;
  }
}

Eigen::Vector2d HeidenhainIsoForm::centre(ArcAxes axes, int column) const
{
  const Eigen::Vector2d pole(pole_[axes.u], pole_[axes.v]);
  if (!pole.allFinite())
    fail(column, "an arc without radius, and without a pole, I J, before it");
  return pole;
}

} // namespace pointmill::gcode
