// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/visual/colour.h>

#include <string>

namespace pointmill::viewer {

/// @brief A number of at most four digits that count.
std::string numberText(double value);
/// @brief "1:23:45", hours, minutes and seconds.
std::string clockText(double seconds);
/// @brief Seconds of a clock that only goes on.
double secondsNow();
/// @brief Whether a background needs light writing.
inline bool isDark(const visual::Rgb& background)
{
  return background.r + background.g + background.b < 1.5f;
}
/// @brief Colour of writing on a background.
inline visual::Rgb inkOn(const visual::Rgb& background)
{
  return isDark(background) ? visual::kPage : visual::kInk;
}
/// @brief Colour of a figure from 0 to 1: purple over red to orange, ever lighter, but
/// never so light that it is lost on white or on the map (after magma).
visual::Rgb scaleColour(float share);

} // namespace pointmill::viewer
