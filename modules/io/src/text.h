// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

namespace pointmill::detail {

/// @brief A stretch of text that is consumed from its front.
struct Text {
  const char* at;
  const char* end;

  bool done() const { return at == end; }
};

inline bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

/// @brief Whether a number may end at the front of @p text.
inline bool atBreak(const Text& text)
{
  return text.done() || isBlank(*text.at);
}

inline void skipBlanks(Text& text)
{
  while (!text.done() && isBlank(*text.at))
    ++text.at;
}

/// @brief Skips what is left of a word.
inline void skipWord(Text& text)
{
  while (!atBreak(text))
    ++text.at;
}

/// @brief Takes the next line, without its end; false where nothing is left.
bool takeLine(Text& rest, Text& line);

/// @brief Takes the next blank-separated word; empty where there is none.
std::string takeWord(Text& text);

/// @brief Takes a number in any form that C writes one, nan and inf too, always with a
/// decimal point; leaves @p text as it is and returns false where there is none.
bool takeNumber(Text& text, double& value);
bool takeNumber(Text& text, long long& value);
bool takeNumber(Text& text, unsigned long long& value);

/// @brief Skips blanks and takes a number that ends at a blank or the end.
template <typename Number>
bool takeWholeNumber(Text& text, Number& value)
{
  skipBlanks(text);
  return takeNumber(text, value) && atBreak(text);
}

/// @brief The line in quotes, shortened, for a message.
std::string quoted(const Text& line);

/// @brief In lower case, as far as ASCII goes.
std::string lower(std::string text);

} // namespace pointmill::detail
