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

} // namespace

Number scanNumber(const char* p, const char* end)
{
  bool negative = false, point = false, sign = false;
  int digits = 0, decimals = 0;
  std::uint64_t mantissa = 0;
  for (; p != end; ++p) {
    const char c = *p;
    if (isDigit(c)) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
      decimals += point;
      if (++digits > most_digits)
        return {Number::State::TooLong, 0.0, p};
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
  if (digits == 0)
    return {Number::State::Missing, 0.0, p};
  const double magnitude = static_cast<double>(mantissa) / powers[decimals];
  return {Number::State::Good, negative ? -magnitude : magnitude, p};
}

} // namespace pointmill::gcode
