// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "camera.h"
#include "text.h"

namespace pointmill::visual {

/// @brief Largest of 1, 2, 5 x 10^n that is at most @p limit; its label is in mm.
double niceLength(double limit);

/// @brief A number for people: no needless digits.
std::string number(double value);

/// @brief Scale bar of a nice length, at most @p room px, its left end at (x, y).
/// @param scale px per mm
/// @return px that bar and label take to the right of x
int drawScaleBar(
    Canvas& canvas, int x, int y, int room, double scale, const TextStyle& style);

/// @brief The part frame's axes, in a circle of @p radius px about (x, y).
void drawAxes(
    Canvas& canvas, const Camera& camera, int x, int y, float radius, TextStyle style);

} // namespace pointmill::visual
