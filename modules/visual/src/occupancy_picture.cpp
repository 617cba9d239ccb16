// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "grid.h"
#include "ruler.h"
#include "text.h"

#include <pointmill/visual/occupancy_kind.h>
#include <pointmill/visual/occupancy_picture.h>

#include <array>
#include <cmath>

namespace pointmill {

using namespace visual;

void writeOccupancy(const std::string& path, const CellCloud& map, double level_z)
{
  const Grid grid(map, "the occupancy map");
  using Kind = OccupancyKind;
  std::array<std::size_t, 3> count{};
  for (const PointCell& cell : map)
    ++count[static_cast<std::size_t>(occupancyAt(cell, level_z))];
  CellSheet sheet(
      grid, "occupancy at z = " + number(level_z) + " mm", [&](const PointCell& cell) {
        return colourOf(occupancyAt(cell, level_z));
      });

  Canvas& canvas = sheet.canvas();
  const TextStyle text = CellSheet::text();
  const int foot = sheet.footMiddle();
  const char* const names[] = {"free", "part", "gap, protected"};
  const auto total = static_cast<double>(map.size());
  int x = sheet.right(); // and on to the left
  for (const Kind kind : {Kind::Protected, Kind::Free, Kind::Occupied}) {
    const auto k = static_cast<std::size_t>(kind);
    const std::string label =
        std::string(names[k]) + " " +
        number(std::round(1000.0 * static_cast<double>(count[k]) / total) / 10.0) +
        " %";
    x -= textWidth(label, text);
    drawText(canvas, x, foot, label, text);
    x -= 30;
    canvas.fillRound({x, foot - 10, 20, 20}, 4.f, colourOf(kind));
    x -= 28;
  }
  writePng(path, canvas);
}

} // namespace pointmill
