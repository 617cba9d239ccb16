// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <string>

namespace pointmill::visual {

struct TextStyle {
  int size = 16; ///< px from the ascenders to the descenders, about
  bool bold = false;
  Rgb colour = kInk;
};

/// @brief Width of a line of UTF-8 text [px].
int textWidth(const std::string& text, const TextStyle& style);

/// @brief Draws a line of UTF-8 text with its left end at @p x and its middle (half way
/// between ascender and descender) at @p y_middle. Characters that VTK's built-in font
/// lacks are left out.
/// @return its width [px]
int drawText(
    Canvas& canvas, int x, int y_middle, const std::string& text, const TextStyle&);

/// @brief The text, or its beginning and "..." where it is wider than @p width px.
std::string fitText(const std::string& text, int width, const TextStyle& style);

} // namespace pointmill::visual
