// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cell_sheet.h"
#include "ruler.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {
namespace {

constexpr int kPicture = 1400;  // px, longer side of the cells where they allow it
constexpr int kLargest = 6000;  // px; beyond, cells are left out
constexpr int kNarrowest = 900; // px, for the texts

/// Size of a cell in the picture: so many px, or one px for so many cells.
struct Zoom {
  explicit Zoom(const Grid& grid) : Zoom(std::max(grid.columns(), grid.rows())) {}
  explicit Zoom(int cells)
      : px(std::max(1, kPicture / cells)), stride((cells + kLargest - 1) / kLargest)
  {
  }
  int px;
  int stride;
  int size(int cells) const { return (cells + stride - 1) / stride * px; }
};

} // namespace

CellSheet::CellSheet(const Grid& grid,
                     const std::string& title,
                     const ColourOf& colour_of,
                     int foot)
    : columns_(grid.columns()), rows_(grid.rows()), right_(grid.stepX() > 0),
      up_(grid.stepY() > 0), foot_(foot),
      canvas_(std::max(Zoom(grid).size(grid.columns()) + 2 * kMargin, kNarrowest),
              kHead + Zoom(grid).size(grid.rows()) + foot,
              kPage)
{
  const Zoom zoom(grid);
  px_ = zoom.px;
  stride_ = zoom.stride;
  left_ = (canvas_.width() - zoom.size(grid.columns())) / 2;
  for (int r = 0; r < grid.rows(); r += zoom.stride)
    for (int c = 0; c < grid.columns(); c += zoom.stride)
      canvas_.fill(place(c, r), colour_of(grid.cell(c, r)));
  drawText(canvas_, kMargin, kHead / 2, title, {30, true, kInk});
  drawScaleBar(canvas_,
               kMargin,
               footMiddle(),
               200,
               zoom.px / (std::abs(grid.stepX()) * zoom.stride),
               text());
}

Rect CellSheet::place(int column, int row) const
{
  // Y runs up in the part and down in the picture.
  const int c = (right_ ? column : columns_ - 1 - column) / stride_;
  const int r = (up_ ? rows_ - 1 - row : row) / stride_;
  return {left_ + c * px_, kHead + r * px_, px_, px_};
}

} // namespace pointmill::visual
