// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "badge.h"

namespace pointmill::visual {

void drawBadge(Canvas& canvas, int x, int y, std::size_t number, bool warning, int unit)
{
  const int half = unit * 3 / 2, rim = std::max(1, unit / 5);
  const auto shape = [&](int reach, const Rgb& colour) {
    const float round =
        warning ? 0.25f * static_cast<float>(reach) : static_cast<float>(reach);
    canvas.fillRound({x - reach, y - reach, 2 * reach, 2 * reach}, round, colour);
  };
  shape(half + rim, kPage);
  shape(half, warning ? kWarning : kError);
  const std::string text = std::to_string(number);
  const TextStyle style{
      text.size() > 2 ? unit * 3 / 2 : 2 * unit, true, warning ? kInk : kPage};
  drawText(canvas, x - textWidth(text, style) / 2, y, text, style);
}

int drawPill(Canvas& canvas,
             int x,
             int y_middle,
             const std::string& text,
             const TextStyle& style,
             const Rgb& colour)
{
  const int room = style.size * 2 / 3, height = style.size * 8 / 5;
  const int width = textWidth(text, style) + 2 * room;
  canvas.fillRound({x, y_middle - height / 2, width, height},
                   0.25f * static_cast<float>(height),
                   colour);
  drawText(canvas, x + room, y_middle, text, style);
  return width;
}

} // namespace pointmill::visual
