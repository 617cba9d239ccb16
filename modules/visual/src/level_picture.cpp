// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "flow.h"
#include "grid.h"
#include "level_ground.h"
#include "level_legend.h"
#include "level_lines.h"
#include "level_moves.h"
#include "ruler.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/visual/level_picture.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using namespace visual;

constexpr int kUnits = 84;        ///< to the picture's width; all sizes follow
constexpr double kTallest = 1.15; ///< of the drawing, relative to its width

/// All that a picture must hold [mm].
Eigen::AlignedBox2d boxOf(const LevelScene& scene, const LevelMoves& moves)
{
  Eigen::AlignedBox2d box(Eigen::Vector2d(scene.stock.min.head<2>()),
                          Eigen::Vector2d(scene.stock.max.head<2>()));
  const double margin = 0.01 * box.diagonal().norm();
  for (const auto& m : moves.moves)
    if (m.kind != MoveKind::Rapid) {
      box.extend(m.from);
      box.extend(m.to);
    }
  for (const auto& at : moves.entries)
    box.extend(at);
  const Eigen::Vector2d room(margin, margin);
  return {box.min() - room, box.max() + room};
}

/// The box at the largest scale that the width and kTallest allow, in the middle.
Plan planOf(const Eigen::AlignedBox2d& box, int left, int top, int width)
{
  Plan plan;
  const Eigen::Vector2d size = box.sizes();
  plan.scale = std::min(width / size.x(), kTallest * width / size.y());
  plan.place = {left, top, width, static_cast<int>(std::ceil(size.y() * plan.scale))};
  plan.corner = {box.center().x() - 0.5 * width / plan.scale, box.max().y()};
  return plan;
}

void drawStock(Canvas& canvas, const Plan& plan, const Stock& stock, float thickness)
{
  const Eigen::Vector2f a = plan.px(Eigen::Vector2d(stock.min.head<2>()));
  const Eigen::Vector2f b = plan.px(Eigen::Vector2d(stock.max.head<2>()));
  for (const float x : {a.x(), b.x()})
    canvas.line(x, a.y(), x, b.y(), thickness, kStockEdge);
  for (const float y : {a.y(), b.y()})
    canvas.line(a.x(), y, b.x(), y, thickness, kStockEdge);
}

void check(const LevelScene& scene, int width)
{
  checkRange("level picture", "width", width, "px", {400, 4000});
  scene.tool.validate();
  if (!scene.map || !scene.path)
    throw DataError("level picture: the scene has no map or no path");
  const Eigen::Vector3d size = scene.stock.max - scene.stock.min;
  if (!(size.x() > 0 && size.y() > 0 && size.allFinite()))
    throw DataError("level picture: the stock has no area");
}

} // namespace

double heightOfLevel(const CLCloud& path, std::uint32_t level)
{
  double z = std::numeric_limits<double>::infinity();
  for (const auto& p : path)
    if (p.level == level && p.getMotion() == Motion::Cut)
      z = std::min<double>(z, p.z);
  if (!std::isfinite(z))
    throw DataError("nothing is cut on level " + std::to_string(level));
  return z;
}

void writeLevel(const std::string& path, const LevelScene& scene, int width)
{
  check(scene, width);
  const double z = heightOfLevel(*scene.path, scene.level);
  const LevelMoves moves = movesOfLevel(*scene.path, scene.level);

  const int unit = std::max(4, width / kUnits);
  const int margin = 2 * unit, room = width - 2 * margin;
  const TextStyle title{3 * unit, true, kInk}, text{2 * unit, false, kFaintInk};
  std::vector<int> widths;
  for (const auto& figure : scene.figures)
    widths.push_back(textWidth(figure, text));
  const Flow figures(widths, 2 * unit, room);
  const int figures_top = 6 * unit;
  const int top = figures_top + figures.lines * 3 * unit + unit;
  const Plan plan = planOf(boxOf(scene, moves), margin, top, room);
  const Key legend = levelLegend(scene, moves, z, room, unit);
  const int ruler = plan.place.bottom() + 3 * unit;
  Canvas canvas(width, ruler + 2 * unit + legend.height() + unit, kPage);

  drawText(
      canvas, margin, 3 * unit + unit / 2, fitText(scene.title, room, title), title);
  for (std::size_t i = 0; i < scene.figures.size(); ++i)
    drawText(canvas,
             margin + figures.at[i].x,
             figures_top + figures.at[i].line * 3 * unit + unit,
             fitText(scene.figures[i], room, text),
             text);
  drawGround(canvas, plan, scene, moves, z);
  const float thickness = lineThickness(unit);
  drawStock(canvas, plan, scene.stock, 0.7f * thickness);
  drawMoves(canvas, plan, moves, thickness);
  drawScaleBar(canvas, margin, ruler, room / 4, plan.scale, {2 * unit, false, kInk});
  legend.draw(canvas, margin, ruler + 2 * unit);
  canvas.posterise(kTones);
  writePng(path, canvas);
}

} // namespace pointmill
