// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill::gcode {

inline bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}
inline bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}
inline char upper(char c)
{
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}
inline bool isLetter(char c)
{
  return upper(c) >= 'A' && upper(c) <= 'Z';
}

/// @brief A decimal number without exponent, whatever the locale.
struct Number {
  enum class State { Good, Missing, TooLong };

  State state = State::Missing;
  double value = 0.0;
  const char* end = nullptr; ///< behind it
};

/// @brief Reads a number from @p p on. Blanks may stand in it, as RS-274 has it.
Number scanNumber(const char* p, const char* end);

} // namespace pointmill::gcode
