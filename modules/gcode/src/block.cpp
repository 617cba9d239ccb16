// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "block.h"

#include <cmath>

namespace pointmill::gcode {

std::string wordName(char letter)
{
  switch (letter) {
  case Block::Tolerance:
    return "CTOL";
  case Block::Rounding:
    return "ADIS";
  case Block::HighSpeed:
    return "CYCLE832";
  default:
    return std::string(1, letter);
  }
}

void Block::refuseSecondOwner(char letter) const
{
  fail(column(letter), wordName(letter) + " belongs to two words");
}

char Block::leftOver() const
{
  const std::uint32_t left = present_ & ~used_ & ~bit('N');
  if (left)
    for (int i = 0; i < places; ++i)
      if ((left >> i) & 1u)
        return static_cast<char>('A' + i);
  return 0;
}

void Block::addCode(char letter, double number, int column)
{
  const double tenths = number * 10;
  int& count = letter == 'G' ? g_count_ : m_count_;
  if (!(tenths >= 0 && tenths < 10000) || std::abs(tenths - std::round(tenths)) > 1e-6)
    fail(column, std::string("the number after ") + letter + " is no code");
  if (count == most_codes)
    fail(column, std::string("too many ") + letter + " words");
  (letter == 'G' ? g_ : m_)[count++] = {static_cast<int>(std::lround(tenths)), column};
}

void Block::addWord(char letter, double value, int column, Frame frame)
{
  if (letter == 'N' && !isEmpty())
    fail(column, "N must be the first word");
  if (letter == 'N' && value < 0)
    fail(column, "N must not be negative");
  if (has(letter))
    fail(column, "a second " + wordName(letter) + " word");
  present_ |= bit(letter);
  if (frame == Frame::Absolute)
    absolute_ |= bit(letter);
  if (frame == Frame::Incremental)
    incremental_ |= bit(letter);
  values_[letter - 'A'] = value;
  columns_[letter - 'A'] = column;
}

} // namespace pointmill::gcode
