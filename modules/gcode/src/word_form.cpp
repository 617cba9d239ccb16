// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "word_form.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

constexpr double farthest = 1e5;  // mm
constexpr double shortest = 1e-9; // mm; less is the rounding of sums

/// What a word belongs to that nothing in its block has taken.
const char* ownersOf(char letter)
{
  switch (letter) {
  case 'E':
    return "G187";
  case 'H':
    return "G43";
  case 'I':
  case 'J':
  case 'K':
  case 'R':
    return "G2 or G3";
  case 'P':
    return "G4, G64 or another word that takes it";
  case 'Q':
    return "G64 or G5.1";
  default:
    return "a word that takes it";
  }
}

constexpr const char* no_unit = ": its unit is unknown";

const char* unitWords(ProgramForm form)
{
  return form == ProgramForm::Siemens ? "G71 or G70" : "G20 or G21";
}

const char* motionName(int tenths)
{
  return tenths == 10 ? "G1" : tenths == 20 ? "G2" : "G3";
}

/// The work offset that is in force before any is selected.
const char* firstOffset(ProgramForm form)
{
  return form == ProgramForm::Rs274 || form == ProgramForm::Grbl ? "G54" : "";
}

} // namespace

WordForm::WordForm(ProgramForm form, MachineState& machine)
    : machine_(machine), form_(form), table_(form), lexer_(form)
{
}

bool WordForm::obey(std::string_view text, std::size_t line)
{
  lexer_.read(text, line, block_);
  machine_.setLine(line);
  if (!block_.comment().empty())
    machine_.comment(block_.comment());
  if (block_.isPercent()) {
    if (started_ || percent_)
      return false;
    percent_ = true;
    return true;
  }
  if (block_.isEmpty())
    return true;
  const bool goes_on = execute();
  started_ = true;
  return goes_on;
}

bool WordForm::execute()
{
  sortCodes();
  // Most blocks only go on to the next position.
  if (!block_.onlyMoves()) {
    if (block_.has('O'))
      readProgramNumber();
    if (is(NonModal, 40))
      dwell();
    setUnits();
    setFeedAndSpeed();
    setTool();
    runSpindle();
    setModes();
    setLength();
    if (code(Offset))
      setOffset();
    setPath();
    if (code(NonModal) || code(MachineFrame))
      obeyNonModal();
  }
  else
    setFeedAndSpeed();
  setPole();
  move();
  checkLeftOver();
  return !code(Stop) || !stop();
}

void WordForm::readProgramNumber()
{
  block_.take('O');
  if (started_)
    fail('O', "O (subprogram) is not supported");
}

/// Whether the program ends.
bool WordForm::stop()
{
  if (is(Stop, 0) || is(Stop, 10)) {
    pause();
    return false;
  }
  machine_.end();
  return true;
}

void WordForm::sortCodes()
{
  std::fill(codes_, codes_ + group_count, nullptr);
  for (int i = 0; i < block_.gCount(); ++i)
    sort('G', block_.g(i), table_.groupOfG(block_.g(i).tenths));
  for (int i = 0; i < block_.mCount(); ++i)
    sort('M', block_.m(i), table_.groupOfM(block_.m(i).tenths));
}

void WordForm::sort(char letter, const Code& word, Group group)
{
  if (group == NoGroup)
    fail(word.column, table_.refusal(letter, word.tenths));
  if (group == NoEffect)
    return;
  if (codes_[group])
    fail(word.column,
         codeName(letter, word.tenths) + " and " +
             codeName(letter, codes_[group]->tenths) + ": two " + groupName(group) +
             " words in one block");
  codes_[group] = &word;
}

double WordForm::length(char letter) const
{
  if (unit_ == 0.0)
    fail(letter, wordName(letter) + " before " + unitWords(form_) + no_unit);
  const double value = block_.take(letter) * unit_;
  if (std::abs(value) > farthest)
    fail(letter, wordName(letter) + " is beyond 100 m");
  return value;
}

int WordForm::whole(char letter, int least, int most) const
{
  const double value = block_.take(letter);
  if (value < least || value > most || value != std::floor(value))
    fail(letter,
         wordName(letter) + " must be a whole number, " + std::to_string(least) +
             " .. " + std::to_string(most));
  return static_cast<int>(value);
}

void WordForm::setUnit(bool inches)
{
  unit_ = inches ? inch : 1.0;
  feed_unit_ = feedUnit(inches);
  if (inches)
    machine_.usesInches();
}

void WordForm::setUnits()
{
  if (!code(Units))
    return;
  const int word = code(Units)->tenths;
  const bool inches = word == 200 || word == 700 || word == 7000;
  // Controls disagree on which unit such an F has.
  if (block_.open('F') && unit_ != 0.0 && unit_ != (inches ? inch : 1.0))
    fail('F', "F in a block that changes the unit");
  setUnit(inches);
}

void WordForm::setFeedAndSpeed()
{
  if (code(FeedMode) && inverse_time_ != is(FeedMode, 930)) {
    inverse_time_ = !inverse_time_;
    feed_ = 0.0; // it was in the other unit
  }
  if (inverse_time_)
    feed_ = 0.0; // each block has its own
  if (block_.open('F')) {
    if (!inverse_time_ && unit_ == 0.0)
      fail('F', std::string("F before ") + unitWords(form_) + no_unit);
    if (!inverse_time_ && feed_unit_ == 0.0)
      fail('F', "F after G70 is in the machine's own unit; G700 says inches");
    feed_ = block_.take('F') * (inverse_time_ ? 1.0 : feed_unit_);
    if (!(feed_ > 0))
      fail('F', "F must be above 0");
    if (feed_ > 1e9)
      fail('F', "F is beyond all machines");
  }
  if (block_.open('S')) {
    const double speed = block_.take('S');
    if (speed < 0)
      fail('S', "S must not be negative");
    machine_.setSpeed(speed);
  }
}

void WordForm::runSpindle()
{
  if (is(Spindle, 30) || is(Spindle, 130))
    machine_.turnSpindle(1);
  else if (is(Spindle, 40) || is(Spindle, 140))
    machine_.turnSpindle(-1);
  else if (is(Spindle, 50))
    machine_.turnSpindle(0);
}

void WordForm::setModes()
{
  if (code(Plane))
    plane_ = code(Plane)->tenths;
  if (code(Distance))
    incremental_ = is(Distance, 910);
  if (code(ArcDistance))
    absolute_centres_ = is(ArcDistance, 901);
  if (code(MotionMode))
    mode_ = code(MotionMode)->tenths;
}

void WordForm::setOffset()
{
  machine_.selectOffset(codeName('G', code(Offset)->tenths));
}

void WordForm::move()
{
  const char axis = block_.firstOf("XYZ");
  const bool arc = mode_ == 20 || mode_ == 30;
  const char extra = arc ? block_.firstOf("IJKR") : '\0';
  if (!axis && !extra) {
    if (arc && code(MotionMode))
      fail(code(MotionMode)->column, codeName('G', mode_) + " without its words");
    return;
  }
  if (is(NonModal, 40))
    fail(axis ? axis : extra, "G4 beside motion");
  if (mode_ == 800)
    fail(axis, std::string(1, axis) + " without G0, G1, G2 or G3");
  const int column =
      code(MotionMode) ? code(MotionMode)->column : block_.column(axis ? axis : extra);
  const Eigen::Vector3d to = target();
  if (mode_ == 0) {
    machine_.rapid(to);
    return;
  }
  if (inverse_time_ && feed_ == 0.0)
    fail(column, codeName('G', mode_) + " in inverse time, G93, without F");
  checkTool(column);
  machine_.checkFeedMove(feed_, motionName(mode_), place(column));
  if (arc) {
    moveOnArc(to, column);
    return;
  }
  if (!inverse_time_) {
    machine_.straight(to, feed_);
    return;
  }
  // Nowhere in a given time is at no feed.
  const double way = (to - machine_.at()).norm();
  if (way > shortest)
    machine_.straight(to, feed_ * way);
}

Eigen::Vector3d WordForm::target(bool zero_stays) const
{
  const auto modal = incremental_ ? Block::Frame::Incremental : Block::Frame::Absolute;
  Eigen::Vector3d to = machine_.at();
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = static_cast<char>('X' + axis);
    if (!block_.open(letter))
      continue;
    const double value = length(letter);
    if (block_.frame(letter, modal) == Block::Frame::Absolute) {
      machine_.enterFrame(block_.place(letter), firstOffset(form_));
      to[axis] = machine_.toPart(axis, value);
      continue;
    }
    const bool known = std::isfinite(to[axis]);
    if (!known && !(zero_stays && value == 0.0))
      fail(letter, std::string("G91: ") + letter + " from an unknown position");
    if (known)
      to[axis] += value;
  }
  return to;
}

void WordForm::moveInMachine(double height_of_zero)
{
  const bool x = block_.open('X'), y = block_.open('Y'), z = block_.open('Z');
  double height = -unbounded;
  if (x)
    length('X');
  if (y)
    length('Y');
  if (z && std::abs(length('Z')) <= near_top)
    height = height_of_zero;
  machine_.toMachinePlace(x, y, z, height);
}

void WordForm::moveOnArc(const Eigen::Vector3d& to, int column)
{
  const auto axes = ArcAxes::of(plane_);
  const Eigen::Vector3d& at = machine_.at();
  const bool clockwise = mode_ == 20;
  Eigen::Vector2d middle;
  if (block_.open('R')) {
    if (const char other = block_.firstOf("IJK"))
      fail(other, std::string(1, other) + " beside R");
    const double radius = length('R');
    const Eigen::Vector2d from(at[axes.u], at[axes.v]), end(to[axes.u], to[axes.v]);
    if ((end - from).norm() < 2e-6)
      fail(column, "an arc with R must not end where it starts");
    const auto found = centreByRadius(from, end, radius, clockwise);
    if (!found)
      fail('R', "R is too small to reach the end of the arc");
    middle = *found;
  }
  else
    middle = centre(axes, column);
  const Arc arc(at, to, middle, axes, clockwise);
  machine_.arc(arc, inverse_time_ ? feed_ * arc.length() : feed_, place(column));
}

Eigen::Vector2d WordForm::centre(ArcAxes axes, int column) const
{
  const auto letter = [](int axis) { return static_cast<char>('I' + axis); };
  if (block_.open(letter(axes.w)))
    fail(letter(axes.w),
         std::string(1, letter(axes.w)) + " does not belong to plane " +
             codeName('G', plane_));
  if (!block_.open(letter(axes.u)) && !block_.open(letter(axes.v)))
    fail(column, "an arc without centre or radius");
  const auto modal =
      absolute_centres_ ? Block::Frame::Absolute : Block::Frame::Incremental;
  const auto along = [&](int axis) {
    const char word = letter(axis);
    if (!block_.open(word)) {
      if (absolute_centres_)
        fail(column, std::string("an arc in G90.1 without ") + word);
      return machine_.at()[axis];
    }
    const double value = length(word);
    return block_.frame(word, modal) == Block::Frame::Absolute
               ? machine_.toPart(axis, value)
               : machine_.at()[axis] + value;
  };
  const double u = along(axes.u);
  return {u, along(axes.v)};
}

void WordForm::checkLeftOver() const
{
  if (block_.open('P') && (mode_ == 20 || mode_ == 30))
    fail('P', "P (turns of an arc) is not supported");
  if (const char left = block_.leftOver())
    fail(left, wordName(left) + " without " + ownersOf(left));
}

} // namespace pointmill::gcode
