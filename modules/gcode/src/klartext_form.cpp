// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "klartext_form.h"

namespace pointmill::gcode {

namespace {

constexpr int largest_number = 9999999;

bool beginsWith(std::string_view text, std::string_view with)
{
  return text.substr(0, with.size()) == with;
}

} // namespace

bool KlartextForm::obey(std::string_view text, std::size_t line)
{
  line_.read(text, line);
  machine_.setLine(line);
  if (continued_) {
    continueCycle();
    return true;
  }
  if (line_.atEnd() && line_.comment().empty())
    return true;
  checkNumber();
  if (!line_.comment().empty())
    machine_.comment(line_.comment());
  if (line_.atEnd())
    return true;
  const Word first = line_.next();
  const bool goes_on = execute(first);
  if (!line_.atEnd())
    line_.fail(line_.peek(),
               "'" + std::string(line_.peek().text) + "' does not belong to " +
                   std::string(first.text));
  return goes_on;
}

void KlartextForm::finish() const
{
  line_.fail("END PGM is missing");
}

/// Blocks are numbered 0, 1, 2 ..; a control refuses or renumbers others.
void KlartextForm::checkNumber()
{
  const Word& word = line_.need("the block's number");
  const int number = line_.whole(word, 0, largest_number);
  if (number != number_ + 1)
    line_.fail(word,
               "block " + std::to_string(number) + " where " +
                   std::to_string(number_ + 1) + " is due");
  number_ = number;
}

bool KlartextForm::execute(const Word& first)
{
  const std::string_view name = first.text;
  if (number_ == 0 && name != "BEGIN")
    line_.fail(first, "the program must begin with BEGIN PGM");
  if (name == "END")
    return endProgram();
  if (ended_)
    line_.fail(first, "a block behind the end of the program");

  if (name == "BEGIN")
    beginProgram();
  else if (name == "BLK" && line_.takes("FORM"))
    // For the control's picture.
    while (!line_.atEnd())
      line_.next();
  else if (name == "TOOL" && line_.takes("CALL"))
    callTool();
  else if (name == "TOOL" && line_.takes("DEF"))
    line_.whole(line_.need("the tool's number"), 0, 32767);
  else if (name == "CYCL" && line_.takes("DEF"))
    defineCycle();
  else if (name == "L")
    moveStraight(first, readPath("XYZFRM"));
  else if (name == "CC")
    setPole(first);
  else if (name == "C")
    moveOnArc(first, readPath("XYZDFRM"));
  else if (name == "CR")
    moveByRadius(first, readPath("XYZDFRM", true));
  else if (name == "CP")
    moveByAngle(first, readPath("ZYXPDFRM"));
  else if (name == "STOP")
    finishPath(readPath("M"));
  else if (beginsWith(name, "M")) {
    Path path;
    readMachineWord(first, path);
    while (!line_.atEnd())
      readMachineWord(line_.next(), path);
    if (path.machine_frame)
      line_.fail(first, "machine coordinates without X, Y or Z");
    finishPath(path);
  }
  else
    line_.fail(first, std::string(name) + " is not supported");
  return true;
}

void KlartextForm::beginProgram()
{
  const Word& pgm = line_.need("PGM");
  if (number_ != 0 || pgm.text != "PGM")
    line_.fail(pgm, "BEGIN PGM must be block 0");
  name_ = line_.need("the program's name").text;
  const Word& unit = line_.need("the program's unit, MM or INCH");
  if (unit.text != "MM" && unit.text != "INCH")
    line_.fail(unit, "the program's unit must be MM or INCH");
  if (unit.text == "INCH") {
    unit_ = inch;
    feed_unit_ = inch / 10; // feeds are in tenths of an inch a minute
    machine_.usesInches();
  }
}

bool KlartextForm::endProgram()
{
  const Word& pgm = line_.need("PGM");
  if (pgm.text != "PGM")
    line_.fail(pgm, "PGM is missing behind END");
  const Word& name = line_.need("the program's name");
  if (name.text != name_)
    line_.fail(name, "the program's name is " + name_);
  const Word& unit = line_.need("the program's unit");
  if (unit.text != (unit_ == inch ? "INCH" : "MM"))
    line_.fail(unit, "the program began with another unit");
  return false;
}

/// "TOOL CALL 3 Z S12000 F500": the tool with its length, its axis, speed and feed.
void KlartextForm::callTool()
{
  int number = -1;
  bool axis = false;
  while (!line_.atEnd()) {
    const Word word = line_.next();
    const char letter = word.text.front();
    if (letter == '"')
      line_.fail(word, "tools by name are not supported");
    else if (word.text == "Z")
      axis = true;
    else if (letter == 'S')
      setSpeed(word);
    else if (letter == 'F') {
      Path path;
      readFeed(word, path);
    }
    else if (beginsWith(word.text, "DL") || beginsWith(word.text, "DR")) {
      if (line_.value(word, 2) != 0.0)
        line_.fail(word, "a tool that differs from the table is not supported");
    }
    else if (number < 0)
      number = line_.whole(word, 0, 32767);
    else
      line_.fail(word, "'" + std::string(word.text) + "' is not supported");
  }
  if (number < 0)
    return; // another speed
  if (!axis)
    line_.fail("TOOL CALL without the spindle's axis, Z");
  machine_.changeTool(number, number > 0);
}

void KlartextForm::setSpeed(const Word& word)
{
  const double speed = line_.value(word, 1);
  if (speed < 0)
    line_.fail(word, "S must not be negative");
  machine_.setSpeed(speed);
}

/// "CYCL DEF 32.1 T0.01": the tolerance of the path. Dwells are read over.
void KlartextForm::defineCycle()
{
  const Word& word = line_.need("the cycle's number");
  const auto point = word.text.find('.');
  const Word number{word.text.substr(0, point), word.column};
  cycle_ = line_.whole(number, 0, 9999);
  const std::string_view part = point == std::string_view::npos
                                    ? std::string_view()
                                    : word.text.substr(point + 1);
  if (cycle_ != 9 && cycle_ != 32 && cycle_ != 247)
    line_.fail(word, "CYCL DEF " + std::to_string(cycle_) + " is not supported");
  if (cycle_ == 32 && part == "1") {
    if (line_.atEnd())
      machine_.leavePath();
    else {
      const Word tolerance = line_.next();
      if (tolerance.text.front() != 'T')
        line_.fail(tolerance, "T is missing");
      const double value = lengthOf(tolerance, 1);
      if (value < 0)
        line_.fail(tolerance, "T must not be negative");
      machine_.setPath(value, 0.0);
    }
    return;
  }
  continueCycle();
}

/// Of what a cycle's further words say only the work offset matters.
void KlartextForm::continueCycle()
{
  while (!line_.atEnd()) {
    const Word word = line_.next();
    if (cycle_ == 247 && beginsWith(word.text, "Q339="))
      machine_.selectOffset("datum " + std::to_string(line_.whole(word, 5, 9999)));
  }
  continued_ = line_.goesOn();
}

} // namespace pointmill::gcode
