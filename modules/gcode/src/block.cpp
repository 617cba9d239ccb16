// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "block.h"

#include <pointmill/common/error.h>

#include <cmath>
#include <cstring>

namespace pointmill::gcode {

namespace {

constexpr double powers[] = {1e0,
                             1e1,
                             1e2,
                             1e3,
                             1e4,
                             1e5,
                             1e6,
                             1e7,
                             1e8,
                             1e9,
                             1e10,
                             1e11,
                             1e12,
                             1e13,
                             1e14,
                             1e15,
                             1e16,
                             1e17};

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}
bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}
char upper(char c)
{
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}

/// Why a letter that RS-274 knows is not read here.
const char* unsupported(char letter)
{
  switch (letter) {
  case 'A':
  case 'B':
  case 'C':
    return "rotary axis";
  case 'U':
  case 'V':
  case 'W':
    return "second linear axis";
  case 'D':
    return "cutter radius";
  case 'E':
    return "spindle-synchronised feed";
  case 'L':
    return "repetition";
  case 'O':
    return "subroutine or program number";
  default:
    return nullptr;
  }
}

std::string shown(char c)
{
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F)
    return std::string("'") + c + "'";
  const char* const digits = "0123456789ABCDEF";
  return std::string("byte 0x") + digits[byte >> 4] + digits[byte & 15];
}

const char* meaning(char c)
{
  if (c == '#')
    return " (parameters)";
  if (c == '[' || c == ']')
    return " (expressions)";
  if (c == '/')
    return " (block delete)";
  return "";
}

} // namespace

std::string codeName(char letter, int tenths)
{
  std::string name = letter + std::to_string(tenths / 10);
  if (tenths % 10)
    name += "." + std::to_string(tenths % 10);
  return name;
}

void Block::fail(int column, const std::string& what) const
{
  throw DataError("line " + std::to_string(line_) + ", column " +
                  std::to_string(column) + ": " + what);
}

bool Block::hasAny(const char* letters, char& found) const
{
  for (; *letters; ++letters)
    if (has(*letters)) {
      found = *letters;
      return true;
    }
  return false;
}

void Block::parse(std::string_view text, std::size_t line)
{
  line_ = line;
  present_ = 0;
  g_count_ = m_count_ = 0;
  percent_column_ = 0;

  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const char* p = begin;
  const auto columnOf = [begin](const char* at) {
    return static_cast<int>(at - begin) + 1;
  };
  while (p != end) {
    if (isBlank(*p)) {
      ++p;
      continue;
    }
    const int column = columnOf(p);
    if (*p == ';')
      return;
    if (*p == '(') {
      do
        ++p;
      while (p != end && *p != ')' && *p != '(');
      if (p == end)
        fail(column, "the comment is not closed");
      if (*p == '(')
        fail(columnOf(p), "a comment inside a comment");
      ++p;
      continue;
    }
    if (*p == '%') {
      if (percent_column_ != 0 || !isEmpty())
        fail(column, "'%' must stand alone");
      percent_column_ = column;
      ++p;
      continue;
    }
    const char letter = upper(*p);
    if (letter < 'A' || letter > 'Z')
      fail(column, shown(*p) + meaning(*p) + " is not supported");
    if (const char* const what = unsupported(letter))
      fail(column, std::string(1, letter) + " (" + what + ") is not supported");

    // The number: blanks may stand anywhere in it, exponents nowhere.
    ++p;
    bool negative = false, point = false, sign = false;
    int digits = 0, decimals = 0;
    std::uint64_t mantissa = 0;
    for (; p != end; ++p) {
      const char c = *p;
      if (isDigit(c)) {
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
        ++digits;
        decimals += point;
        if (digits > 17)
          fail(column, std::string(1, letter) + " has more than 17 digits");
      }
      else if (c == '.' && !point)
        point = true;
      else if ((c == '-' || c == '+') && !sign && !point && digits == 0) {
        sign = true;
        negative = c == '-';
      }
      else if (!isBlank(c))
        break;
    }
    if (digits == 0) {
      const char* const why = p != end ? meaning(*p) : "";
      if (*why)
        fail(columnOf(p), shown(*p) + why + " is not supported");
      fail(column, std::string(1, letter) + " has no number");
    }
    const double magnitude = static_cast<double>(mantissa) / powers[decimals];
    if (percent_column_ != 0)
      fail(percent_column_, "'%' must stand alone");
    addWord(letter, negative ? -magnitude : magnitude, column);
  }
}

void Block::addWord(char letter, double value, int column)
{
  if (letter == 'G' || letter == 'M') {
    const double tenths = value * 10;
    int& count = letter == 'G' ? g_count_ : m_count_;
    if (!(tenths >= 0 && tenths < 10000) ||
        std::abs(tenths - std::round(tenths)) > 1e-6)
      fail(column, std::string("the number after ") + letter + " is no code");
    if (count == most_codes)
      fail(column, std::string("too many ") + letter + " words");
    (letter == 'G' ? g_ : m_)[count++] = {static_cast<int>(std::lround(tenths)),
                                          column};
    return;
  }
  if (letter == 'N' && !isEmpty())
    fail(column, "N must be the first word");
  if (has(letter))
    fail(column, std::string("a second ") + letter + " word");
  present_ |= 1u << (letter - 'A');
  values_[letter - 'A'] = value;
  columns_[letter - 'A'] = column;
}

} // namespace pointmill::gcode
