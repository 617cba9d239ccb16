// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "grid.h"
#include "ruler.h"
#include "swatches.h"
#include "text.h"
#include <pointmill/visual/occupancy_kind.h>

#include <pointmill/common/error.h>
#include <pointmill/visual/levels_picture.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pointmill {
namespace {

using namespace visual;

constexpr std::size_t kMost = 60;
constexpr int kWidth = 1600, kMargin = 36, kHead = 84, kFoot = 72; // px
constexpr int kRoom = 16, kLabel = 30;                             // px, of a tile

/// Tiles of one size in rows.
struct Tiles {
  /// The fewest columns whose tiles are not much higher than a page is wide.
  Tiles(const Grid& grid, std::size_t count)
  {
    const double shape = static_cast<double>(grid.rows()) * std::abs(grid.stepY()) /
                         (grid.columns() * std::abs(grid.stepX()));
    do {
      ++columns;
      width = (kWidth - 2 * kMargin - (columns - 1) * kRoom) / columns;
      height = std::max(1, static_cast<int>(std::lround(width * shape)));
      rows = (static_cast<int>(count) + columns - 1) / columns;
    } while (columns < static_cast<int>(count) && columns < 10 &&
             (all() > kWidth || width > 520));
  }
  int all() const { return rows * (height + kLabel + kRoom); }
  int columns = 0, rows = 0, width = 0, height = 0;
};

std::string heightText(double z)
{
  char text[32];
  std::snprintf(text, sizeof text, "Z%.3f", z);
  return text;
}

void drawTile(Canvas& canvas, const Grid& grid, const Rect& r, double level)
{
  for (int y = 0; y < r.height; ++y)
    for (int x = 0; x < r.width; ++x) {
      const int c = x * grid.columns() / r.width, d = y * grid.rows() / r.height;
      const PointCell& cell = grid.cell(grid.stepX() > 0 ? c : grid.columns() - 1 - c,
                                        grid.stepY() > 0 ? grid.rows() - 1 - d : d);
      canvas.set(r.x + x, r.y + y, colourOf(occupancyAt(cell, level)));
    }
}

} // namespace

void writeLevels(const std::string& path,
                 const CellCloud& map,
                 const std::vector<double>& levels)
{
  const Grid grid(map, "the occupancy map");
  if (levels.empty())
    throw DataError("there are no levels to show");
  const std::size_t stride = (levels.size() + kMost - 1) / kMost;
  std::vector<double> shown;
  for (std::size_t i = 0; i < levels.size(); i += stride)
    shown.push_back(levels[i]);
  if (shown.back() != levels.back())
    shown.push_back(levels.back());
  const Tiles tiles(grid, shown.size());
  Canvas canvas(kWidth, kHead + tiles.all() + kFoot, kPage);

  drawText(canvas,
           kMargin,
           kHead / 2,
           (stride > 1 ? std::to_string(shown.size()) + " of " : std::string()) +
               std::to_string(levels.size()) +
               (levels.size() == 1 ? " level" : " levels") + ", from the top down",
           {30, true, kInk});
  const TextStyle text{19, false, kInk};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int column = static_cast<int>(i) % tiles.columns;
    const int row = static_cast<int>(i) / tiles.columns;
    const int x = kMargin + column * (tiles.width + kRoom);
    const int y = kHead + row * (tiles.height + kLabel + kRoom);
    drawText(canvas,
             x,
             y + kLabel / 2,
             fitText(heightText(shown[i]), tiles.width, text),
             text);
    drawTile(canvas, grid, {x, y + kLabel, tiles.width, tiles.height}, shown[i]);
  }

  const int foot = canvas.height() - kFoot / 2;
  drawScaleBar(canvas,
               kMargin,
               foot,
               tiles.width,
               tiles.width / (grid.columns() * std::abs(grid.stepX())),
               text);
  drawSwatches(canvas,
               kWidth - kMargin,
               foot,
               {{colourOf(OccupancyKind::Protected), "gap, protected"},
                {colourOf(OccupancyKind::Free), "free"},
                {colourOf(OccupancyKind::Occupied), "part"}},
               text);
  writePng(path, canvas);
}

} // namespace pointmill
