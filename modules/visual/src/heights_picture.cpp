// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "cloud_extent.h"
#include "ramp.h"
#include "ruler.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/heights_picture.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using namespace visual;

/// How light a cell is, 1 on level ground, lit from the upper left.
float lightOn(const Grid& grid, int column, int row)
{
  const float here = grid.z(column, row);
  const auto slope = [&](float before, float after, double step) {
    const double low = std::isfinite(before) ? before : here;
    const double high = std::isfinite(after) ? after : here;
    return (high - low) / (2 * step);
  };
  const Eigen::Vector3d normal(
      -slope(grid.z(column - 1, row), grid.z(column + 1, row), grid.stepX()),
      -slope(grid.z(column, row - 1), grid.z(column, row + 1), grid.stepY()),
      1.0);
  const Eigen::Vector3d lamp = Eigen::Vector3d(-0.5, 0.5, 1.0).normalized();
  const double lit = std::max(0.0, normal.normalized().dot(lamp)) / lamp.z();
  return static_cast<float>(0.35 + 0.65 * std::min(lit, 1.3));
}

/// Of a grey cell, for the legend.
constexpr Rgb kNoHeight = kRule;

} // namespace

void writeHeights(const std::string& path,
                  const CellCloud& field,
                  const std::string& title)
{
  const Grid grid(field, "the height field");
  if (grid.box().isEmpty())
    throw DataError("the height field has no height anywhere");
  Light light;
  heightRange(field, light);
  const auto span = static_cast<float>(std::max(light.high - light.low, 1e-6));
  bool holes = false;
  CellSheet sheet(
      grid,
      title,
      [&](const PointCell& cell) {
        if (!std::isfinite(cell.z)) {
          holes = true;
          return kNoHeight;
        }
        const auto at = static_cast<int>(&cell - field.points.data());
        const float share = (cell.z - static_cast<float>(light.low)) / span;
        return heightColour(share) *
               lightOn(grid, at % grid.columns(), at / grid.columns());
      },
      100);

  Canvas& canvas = sheet.canvas();
  const TextStyle text = CellSheet::text();
  const int foot = sheet.footMiddle();
  constexpr int width = 360, room = 50; // px; half of the outer texts is beside it
  std::vector<RampMark> marks;
  marks.push_back({0.0, lowText(light)});
  marks.push_back({0.5, number(0.5 * (light.low + light.high))});
  marks.push_back({1.0, highText(light)});
  const Rect bar{sheet.right() - width - room, foot - 10, width, 20};
  drawRamp(
      canvas, bar, [](double t) { return heightColour(float(t)); }, marks, text);
  if (holes) {
    const std::string label = "no height";
    const int x = bar.x - 70 - textWidth(label, text);
    drawText(canvas, x, foot, label, text);
    canvas.fillRound({x - 30, foot - 10, 20, 20}, 4.f, kNoHeight);
  }
  writePng(path, canvas);
}

} // namespace pointmill
