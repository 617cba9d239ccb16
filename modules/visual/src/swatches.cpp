// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "swatches.h"

namespace pointmill::visual {

void drawSwatches(Canvas& canvas,
                  int right,
                  int middle,
                  const std::vector<std::pair<Rgb, std::string>>& items,
                  const TextStyle& style)
{
  int x = right;
  for (const auto& [colour, label] : items) {
    x -= textWidth(label, style);
    drawText(canvas, x, middle, label, style);
    x -= 30;
    canvas.fillRound({x, middle - 10, 20, 20}, 4.f, colour);
    x -= 28;
  }
}

} // namespace pointmill::visual
