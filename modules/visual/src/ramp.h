// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "text.h"

#include <functional>
#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief A place of a ramp that has a name.
struct RampMark {
  double at; ///< 0 .. 1 along it
  std::string text;
};

/// @brief Draws a bar of colours from left to right, with marks under it. A mark that
/// would touch the one before it is drawn without its text.
/// @param place of the bar alone; the texts take style.size * 2 below it, and half of
/// the outer ones stands beside it
void drawRamp(Canvas& canvas,
              const Rect& place,
              const std::function<Rgb(double)>& colour,
              const std::vector<RampMark>& marks,
              const TextStyle& style);

} // namespace pointmill::visual
