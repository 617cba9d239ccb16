// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "grid.h"
#include "ruler.h"
#include "swatches.h"
#include "text.h"

#include <pointmill/visual/occupancy_kind.h>
#include <pointmill/visual/occupancy_picture.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

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
  const auto total = static_cast<double>(map.size());
  const auto item = [&](Kind kind, const std::string& name) {
    const double share =
        static_cast<double>(count[static_cast<std::size_t>(kind)]) / total;
    return std::make_pair(
        colourOf(kind), name + " " + number(std::round(1000.0 * share) / 10.0) + " %");
  };
  drawSwatches(canvas,
               sheet.right(),
               sheet.footMiddle(),
               {item(Kind::Protected, "gap, protected"),
                item(Kind::Free, "free"),
                item(Kind::Occupied, "part")},
               text);
  writePng(path, canvas);
}

} // namespace pointmill
