// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "print.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace pointmill {

std::string print(const char* format, ...)
{
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string hoursAndMinutes(double minutes)
{
  const double whole = std::ceil(minutes);
  return print("%.0f h %02.0f min", std::floor(whole / 60), std::fmod(whole, 60.0));
}

} // namespace pointmill
