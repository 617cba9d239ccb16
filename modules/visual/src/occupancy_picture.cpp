// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "grid.h"
#include "ruler.h"
#include "text.h"

#include <pointmill/visual/occupancy_picture.h>

#include <array>
#include <cmath>

namespace pointmill {

namespace {

using namespace visual;

enum Kind { Free, Occupied, Protected };

Kind kindOf(const PointCell& cell, double level_z)
{
  if (cell.getState() == CellState::Gap)
    return cell.z <= level_z ? Free : Protected; // NaN: unknown, protected
  return cell.z > level_z ? Occupied : Free;
}

} // namespace

void writeOccupancy(const std::string& path, const CellCloud& map, double level_z)
{
  const Grid grid(map, "the occupancy map");
  constexpr Rgb colours[] = {kFree, kOccupied, kProtected};
  std::array<std::size_t, 3> count{};
  for (const PointCell& cell : map)
    ++count[kindOf(cell, level_z)];
  CellSheet sheet(
      grid, "occupancy at z = " + number(level_z) + " mm", [&](const PointCell& cell) {
        return colours[kindOf(cell, level_z)];
      });

  Canvas& canvas = sheet.canvas();
  const TextStyle text = CellSheet::text();
  const int foot = sheet.footMiddle();
  const char* const names[] = {"free", "part", "gap, protected"};
  const auto total = static_cast<double>(map.size());
  int x = sheet.right();
  for (const Kind kind : {Protected, Free, Occupied}) { // from the right
    const std::string label =
        std::string(names[kind]) + " " +
        number(std::round(1000.0 * static_cast<double>(count[kind]) / total) / 10.0) +
        " %";
    x -= textWidth(label, text);
    drawText(canvas, x, foot, label, text);
    x -= 30;
    canvas.fillRound({x, foot - 10, 20, 20}, 4.f, colours[kind]);
    x -= 28;
  }
  writePng(path, canvas);
}

} // namespace pointmill
