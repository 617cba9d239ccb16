// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "words.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace pointmill::viewer {

std::string numberText(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::abs(value) < 5e-4 ? 0.0 : value);
  return text;
}

std::string clockText(double seconds)
{
  const auto all = static_cast<long>(std::floor(std::max(0.0, seconds)));
  char text[32];
  std::snprintf(
      text, sizeof text, "%ld:%02ld:%02ld", all / 3600, all / 60 % 60, all % 60);
  return text;
}

double secondsNow()
{
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

visual::Rgb scaleColour(float share)
{
  constexpr visual::Rgb stops[] = {visual::hex(0x1B1044),
                                   visual::hex(0x5F187F),
                                   visual::hex(0xA8327D),
                                   visual::hex(0xE65163),
                                   visual::hex(0xFB8861)};
  const float s = std::clamp(share, 0.f, 1.f) * 4.f;
  const int i = std::min(static_cast<int>(s), 3);
  return visual::mix(stops[i], stops[i + 1], s - static_cast<float>(i));
}

} // namespace pointmill::viewer
