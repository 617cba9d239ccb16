// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "ramp.h"

#include <cmath>
#include <limits>

namespace pointmill::visual {

void drawRamp(Canvas& canvas,
              const Rect& place,
              const std::function<Rgb(double)>& colour,
              const std::vector<RampMark>& marks,
              const TextStyle& style)
{
  for (int x = 0; x < place.width; ++x)
    canvas.fill({place.x + x, place.y, 1, place.height},
                colour((x + 0.5) / place.width));
  const int below = place.bottom() + style.size;
  int free = std::numeric_limits<int>::min(); // of texts
  for (const RampMark& mark : marks) {
    const int x = place.x + static_cast<int>(std::lround(mark.at * place.width));
    canvas.fill({x - 1, place.y - 3, 2, place.height + 7}, kInk);
    const int width = textWidth(mark.text, style), left = x - width / 2;
    if (left < free)
      continue;
    drawText(canvas, left, below, mark.text, style);
    free = left + width + style.size / 3;
  }
}

} // namespace pointmill::visual
