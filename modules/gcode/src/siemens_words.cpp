// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What Siemens has beyond letters with numbers: names, `=` and calls.
#include "number.h"
#include "word_lexer.h"

namespace pointmill::gcode {

namespace {

/// G53 in tenths of a code.
constexpr double machine_frame = 53;

/// Settings of the drives and of what is not read, with no influence on the path.
bool hasNoEffect(const std::string& name)
{
  for (const char* const known : {"SOFT", "BRISK", "FFWON", "FFWOF", "COMPOF"})
    if (name == known)
      return true;
  return false;
}

} // namespace

bool WordLexer::skipsTo(char c)
{
  while (p_ != end_ && isBlank(*p_))
    ++p_;
  if (p_ == end_ || *p_ != c)
    return false;
  ++p_;
  return true;
}

/// A name of at least two letters, or a letter with `=`; leaves the rest to readWord().
bool WordLexer::readName()
{
  const char* const at = p_;
  const char* behind = at;
  while (behind != end_ && (isLetter(*behind) || *behind == '_'))
    ++behind;
  const bool letters = behind - at >= 2;
  while (letters && behind != end_ && (isDigit(*behind) || *behind == '_'))
    ++behind;
  if (behind == at)
    return false;
  std::string name;
  for (const char* c = at; c != behind; ++c)
    name += upper(*c);
  p_ = behind;
  if (skipsTo('=')) {
    readAssignment(name, at);
    return true;
  }
  if (!letters) {
    p_ = at;
    return false;
  }
  if (skipsTo('('))
    readCall(name, at);
  else if (name == "SUPA")
    block_->addCode('G', machine_frame, columnOf(at));
  else if (!hasNoEffect(name))
    fail(at, name + " is not supported");
  return true;
}

void WordLexer::readAssignment(const std::string& name, const char* at)
{
  char place = 0;
  if (name == "CR")
    place = 'R';
  else if (name == "CTOL")
    place = Block::Tolerance;
  else if (name == "ADIS")
    place = Block::Rounding;
  else if (name.size() == 1 &&
           std::string("DFIJKSTXYZ").find(name) != std::string::npos)
    place = name[0];
  else
    fail(at, name + "= is not supported");

  auto frame = Block::Frame::Modal;
  while (p_ != end_ && isBlank(*p_))
    ++p_;
  if (name == "T" && p_ != end_ && *p_ == '"')
    fail(p_, "tools by name are not supported");
  if (end_ - p_ >= 2 && upper(p_[1]) == 'C' &&
      (upper(p_[0]) == 'A' || upper(p_[0]) == 'I')) {
    if (place < 'I' || (place > 'K' && place < 'X') || place > 'Z')
      fail(p_, "AC and IC belong to X Y Z I J K");
    frame = upper(p_[0]) == 'A' ? Block::Frame::Absolute : Block::Frame::Incremental;
    const char* const function = p_;
    p_ += 2;
    if (!skipsTo('('))
      fail(function, "a '(' is missing");
  }
  const double value = number(at);
  if (frame != Block::Frame::Modal && !skipsTo(')'))
    fail(at, "a ')' is missing");
  block_->addWord(place, value, columnOf(at), frame);
}

/// What is shown to people is read over; of the cycles only the tolerance is known.
void WordLexer::readCall(const std::string& name, const char* at)
{
  const bool shows = name == "MSG" || name == "WORKPIECE";
  if (!shows && name != "CYCLE832") {
    const bool drills = name.rfind("CYCLE8", 0) == 0 && name.size() == 7;
    fail(at, name + (drills ? " (canned drilling)" : "") + " is not supported");
  }
  double tolerance = 0.0;
  if (!shows && p_ != end_ && *p_ != ')')
    tolerance = number(at);
  bool quoted = false;
  const char* const inside = p_;
  while (p_ != end_ && (quoted || *p_ != ')')) {
    if (*p_ == '"')
      quoted = !quoted;
    ++p_;
  }
  if (p_ == end_)
    fail(at, name + ": a ')' is missing");
  if (name == "MSG" && p_ - inside >= 2 && *inside == '"' && p_[-1] == '"')
    block_->setComment({inside + 1, static_cast<std::size_t>(p_ - inside - 2)});
  ++p_;
  if (!shows)
    block_->addWord(Block::HighSpeed, tolerance, columnOf(at));
}

} // namespace pointmill::gcode
