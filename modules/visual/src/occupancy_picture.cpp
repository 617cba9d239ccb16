// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas.h"
#include "grid.h"
#include "png.h"
#include "ruler.h"
#include "text.h"

#include <pointmill/visual/occupancy_picture.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pointmill {

namespace {

using namespace visual;

constexpr int kPicture = 1400; // px, longer side of the cells where they allow it
constexpr int kLargest = 6000; // px; beyond, cells are left out
constexpr int kMargin = 36;
constexpr int kHead = 84;
constexpr int kFoot = 72;
constexpr int kNarrowest = 900; // px, for the texts

enum Kind { Free, Occupied, Protected };

Kind kindOf(const PointCell& cell, double level_z)
{
  if (cell.getState() == CellState::Gap)
    return cell.z <= level_z ? Free : Protected; // NaN: unknown, protected
  return cell.z > level_z ? Occupied : Free;
}

/// Size of a cell in the picture: so many px, or one px for so many cells.
struct Zoom {
  explicit Zoom(int cells)
      : px(std::max(1, kPicture / cells)), stride((cells + kLargest - 1) / kLargest)
  {
  }
  int px;
  int stride;
  int size(int cells) const { return (cells + stride - 1) / stride * px; }
};

} // namespace

void writeOccupancy(const std::string& path, const CellCloud& map, double level_z)
{
  const Grid grid(map, "the occupancy map");
  const Zoom zoom(std::max(grid.columns(), grid.rows()));
  const Rect place{0, kHead, zoom.size(grid.columns()), zoom.size(grid.rows())};
  const int width = std::max(place.width + 2 * kMargin, kNarrowest);
  Canvas canvas(width, kHead + place.height + kFoot, kPage);
  const int left = (width - place.width) / 2;

  constexpr Rgb colours[] = {kFree, kOccupied, kProtected};
  std::array<std::size_t, 3> count{};
  for (int r = 0; r < grid.rows(); ++r)
    for (int c = 0; c < grid.columns(); ++c) {
      const Kind kind = kindOf(grid.cell(c, r), level_z);
      ++count[kind];
      if (c % zoom.stride != 0 || r % zoom.stride != 0)
        continue;
      // Y runs up in the part and down in the picture.
      const int column = (grid.stepX() > 0 ? c : grid.columns() - 1 - c) / zoom.stride;
      const int row = (grid.stepY() > 0 ? grid.rows() - 1 - r : r) / zoom.stride;
      canvas.fill({left + column * zoom.px, kHead + row * zoom.px, zoom.px, zoom.px},
                  colours[kind]);
    }

  const int head = kHead / 2;
  const TextStyle title{30, true, kInk}, text{19, false, kInk};
  drawText(canvas, kMargin, head, "occupancy at z = " + number(level_z) + " mm", title);
  const int foot = kHead + place.height + kFoot / 2;
  drawScaleBar(canvas,
               kMargin,
               foot,
               200,
               zoom.px / (std::abs(grid.stepX()) * zoom.stride),
               text);
  const char* const names[] = {"free", "part", "gap, protected"};
  const auto total = static_cast<double>(map.size());
  int x = width - kMargin;
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
