// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "ruler.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/spacing_picture.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

using namespace visual;

void writeSpacing(const std::string& path, const CellCloud& map)
{
  const Grid grid(map, "the spacing map");
  float worst = 0;
  for (const PointCell& cell : map)
    worst = std::isfinite(cell.z) ? std::max(worst, cell.z) : worst;
  if (!(worst > 0))
    throw DataError("the spacing map has no spacing: no point covers any of it");
  CellSheet sheet(grid, "spacing of the points", [&](const PointCell& cell) {
    return std::isfinite(cell.z) ? heightColour(cell.z / worst) : kRule;
  });

  // From the right: the worst, the colours down to 0, and 0.
  Canvas& canvas = sheet.canvas();
  const TextStyle text = CellSheet::text();
  const int foot = sheet.footMiddle();
  const std::string most = number(std::round(1000.0 * worst) / 1000.0) + " mm";
  constexpr int kRamp = 240, kRoom = 12; // px
  int x = sheet.right() - textWidth(most, text);
  drawText(canvas, x, foot, most, text);
  x -= kRamp + kRoom;
  for (int i = 0; i < kRamp; ++i)
    canvas.fill({x + i, foot - 10, 1, 20},
                heightColour(static_cast<float>(i) / (kRamp - 1)));
  x -= textWidth("0", text) + kRoom;
  drawText(canvas, x, foot, "0", text);
  writePng(path, canvas);
}

} // namespace pointmill
