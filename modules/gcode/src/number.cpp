// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "number.h"

#include <cstdint>

namespace pointmill::gcode {

namespace {

constexpr int most_digits = 17;
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

/// Reads digits, with blanks between, into @p mantissa; returns how many.
int scanDigits(const char*& p, const char* end, std::uint64_t& mantissa)
{
  int digits = 0;
  for (; p != end && (isDigit(*p) || isBlank(*p)); ++p)
    if (isDigit(*p) && ++digits <= most_digits)
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
  return digits;
}

} // namespace

Number scanNumber(const char* p, const char* end)
{
  while (p != end && isBlank(*p))
    ++p;
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+'))
    ++p;
  std::uint64_t mantissa = 0;
  int digits = scanDigits(p, end, mantissa), decimals = 0;
  if (p != end && *p == '.') {
    ++p;
    decimals = scanDigits(p, end, mantissa);
    digits += decimals;
  }
  if (digits == 0)
    return {Number::State::Missing, 0.0, p};
  if (digits > most_digits)
    return {Number::State::TooLong, 0.0, p};
  const double magnitude = static_cast<double>(mantissa) / powers[decimals];
  return {Number::State::Good, negative ? -magnitude : magnitude, p};
}

} // namespace pointmill::gcode
