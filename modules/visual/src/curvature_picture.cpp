// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "curvature_scale.h"
#include "hatch.h"
#include "ramp.h"
#include "ruler.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/curvature_picture.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using namespace visual;

constexpr Rgb kNotKnown = kRule;
constexpr Rgb kTooTight = hex(0x5C3006);
constexpr Rgb kHatchInk = hex(0xF3D9AE);

/// The balls among the tools, the largest first, one of each radius.
std::vector<Tool> ballsOf(std::vector<Tool> tools)
{
  const auto isOther = [](const Tool& t) {
    return t.corner_radius <= 0 || t.flatRadius() > 0;
  };
  tools.erase(std::remove_if(tools.begin(), tools.end(), isOther), tools.end());
  std::stable_sort(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) {
    return a.corner_radius > b.corner_radius;
  });
  const auto same = [](const Tool& a, const Tool& b) {
    return a.corner_radius == b.corner_radius;
  };
  tools.erase(std::unique(tools.begin(), tools.end(), same), tools.end());
  return tools;
}

/// What nearly all curvatures keep, to either side [1/mm].
double rangeOf(const CellCloud& hollow, const CellCloud& ridge)
{
  std::vector<float> sizes;
  for (const CellCloud* cells : {&hollow, &ridge})
    for (const PointCell& cell : *cells)
      if (std::isfinite(cell.z))
        sizes.push_back(std::abs(cell.z));
  if (sizes.empty())
    throw DataError("the map of the curvature has none anywhere");
  const auto nearly_all = sizes.begin() + (sizes.size() - 1) * 95 / 100;
  std::nth_element(sizes.begin(), nearly_all, sizes.end());
  return std::max<double>(*nearly_all, 1e-3);
}

} // namespace

void writeCurvature(const std::string& path,
                    const CellCloud& hollow,
                    const CellCloud& ridge,
                    const std::vector<Tool>& tools)
{
  const Grid grid(hollow, "the map of the curvature");
  if (ridge.width != hollow.width || ridge.size() != hollow.size())
    throw DataError("the maps of hollows and ridges are not of one size");
  const std::vector<Tool> balls = ballsOf(tools);
  CurvatureScale scale;
  for (const Tool& ball : balls)
    scale.steps.push_back(1 / ball.corner_radius);
  // The marks of all tools are on the bar, and a piece of it behind the last.
  const double range = rangeOf(hollow, ridge); // throws where nothing is known
  scale.range = balls.empty() ? range : 1.5 * scale.steps.back();

  std::size_t known = 0, tight = 0;
  CellSheet sheet(
      grid,
      "ridges and hollows, radii in mm",
      [&](const PointCell& cell) {
        const PointCell& other = ridge[&cell - hollow.points.data()];
        if (!std::isfinite(cell.z) || !std::isfinite(other.z))
          return kNotKnown;
        ++known;
        tight += scale.isTooTight(cell.z);
        // A hollow that stops a tool counts before any ridge.
        const bool hollow_counts = scale.isTooTight(cell.z) || cell.z > -other.z;
        return scale.at(hollow_counts ? cell.z : other.z);
      },
      140);
  Canvas& canvas = sheet.canvas();
  for (int r = 0; r < grid.rows(); ++r)
    for (int c = 0; c < grid.columns(); ++c)
      if (scale.isTooTight(grid.cell(c, r).z))
        fillHatched(canvas, sheet.place(c, r), Hatch::Rising, kTooTight, kHatchInk);

  const TextStyle text = CellSheet::text();
  const int foot = sheet.footMiddle();
  constexpr int width = 560, room = 60, line = 34; // px
  const Rect bar{sheet.right() - width - room, foot - 10, width, 20};
  std::vector<RampMark> marks{{0, "ridge R " + number(1 / scale.range)}, {0.5, "flat"}};
  for (std::size_t i = 0; i < balls.size(); ++i)
    marks.push_back({0.5 + 0.5 * scale.steps[i] / scale.range,
                     "R " + number(balls[i].corner_radius)});
  if (balls.empty())
    marks.push_back({1, "hollow R " + number(1 / scale.range)});
  drawRamp(
      canvas,
      bar,
      [&](double t) { return scale.at((2 * t - 1) * scale.range); },
      marks,
      text);
  int x = sheet.left();
  const auto item = [&](int y, const std::string& label, const auto& paint) {
    paint(Rect{x, y - 10, 28, 20});
    drawText(canvas, x + 38, y, label, text);
  };
  item(foot + line, "not known", [&](const Rect& r) { canvas.fill(r, kNotKnown); });
  if (!balls.empty())
    item(foot + 2 * line,
         "hollow too tight for " + balls.back().describe() + ": " +
             number(std::round(1000.0 * double(tight) /
                               double(std::max<std::size_t>(1, known))) /
                    10) +
             " %",
         [&](const Rect& r) {
           fillHatched(canvas, r, Hatch::Rising, kTooTight, kHatchInk);
         });
  writePng(path, canvas);
}

} // namespace pointmill
