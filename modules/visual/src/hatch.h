// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

namespace pointmill::visual {

/// @brief Patterns that tell areas apart without a colour.
enum class Hatch { Rising, Crossed, Dots, Falling };

/// @brief Whether a pixel belongs to the lines of a pattern; it runs on from area to
/// area.
inline bool isHatched(Hatch hatch, int x, int y)
{
  constexpr int step = 8;
  const bool rising = (x + y) % step < 2, falling = (x - y + (1 << 20)) % step < 2;
  switch (hatch) {
  case Hatch::Rising:
    return rising;
  case Hatch::Crossed:
    return rising || falling;
  case Hatch::Falling:
    return falling;
  case Hatch::Dots:
    return x % step < 3 && y % step < 3;
  }
  return false;
}

/// @brief Fills a rectangle with a pattern of @p ink on @p ground.
inline void fillHatched(
    Canvas& canvas, const Rect& r, Hatch hatch, const Rgb& ground, const Rgb& ink)
{
  for (int y = r.y; y < r.bottom(); ++y)
    for (int x = r.x; x < r.right(); ++x)
      canvas.set(x, y, isHatched(hatch, x, y) ? ink : ground);
}

} // namespace pointmill::visual
