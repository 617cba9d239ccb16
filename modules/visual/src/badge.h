// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "text.h"

#include <cstddef>

namespace pointmill::visual {

constexpr Rgb kError = kOccupied;
constexpr Rgb kWarning = hex(0xF0B429);

/// @brief Draws the number of a finding with its middle at (x, y): white on a red disc,
/// or black on a yellow square where it is a warning; told apart by shape, too.
/// @param unit [px]; the badge is three wide and high
void drawBadge(
    Canvas& canvas, int x, int y, std::size_t number, bool warning, int unit);

/// @brief The text on a pill of that colour, its left end at @p x.
/// @return its width [px]
int drawPill(Canvas& canvas,
             int x,
             int y_middle,
             const std::string& text,
             const TextStyle& style,
             const Rgb& colour);

} // namespace pointmill::visual
