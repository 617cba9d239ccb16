// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "ticks.h"

#include "ruler.h"
#include "text.h"

#include <cmath>

namespace pointmill::visual {

namespace {

constexpr double kFinest = 0.01; ///< mm, as far as number() tells them apart

void drawFrame(Canvas& canvas, const Rect& r, int thickness)
{
  canvas.fill({r.x, r.y, r.width, thickness}, kStockEdge);
  canvas.fill({r.x, r.bottom() - thickness, r.width, thickness}, kStockEdge);
  canvas.fill({r.x, r.y, thickness, r.height}, kStockEdge);
  canvas.fill({r.right() - thickness, r.y, thickness, r.height}, kStockEdge);
}

/// Calls body(value) for every multiple of @p step in [low, high].
template <typename Body>
void eachMultiple(double low, double high, double step, const Body& body)
{
  const auto last = static_cast<long long>(std::floor(high / step + 1e-9));
  for (auto k = static_cast<long long>(std::ceil(low / step - 1e-9)); k <= last; ++k)
    body(static_cast<double>(k) * step);
}

} // namespace

void drawTicks(Canvas& canvas,
               const Plan& plan,
               const std::string& across,
               const std::string& up,
               int unit)
{
  const Rect& place = plan.place;
  const TextStyle text{2 * unit, false, kFaintInk}, name{2 * unit, true, kFaintInk};
  const int thin = std::max(1, unit / 6), length = unit * 2 / 3;
  const double step = std::max(kFinest, niceLength(20 * unit / plan.scale));
  drawFrame(canvas, place, thin);

  const int row = place.bottom() + 2 * unit;
  const std::string across_name = across + " [mm]";
  const int across_room = textWidth(across_name, name);
  drawText(canvas, place.right() - across_room, row, across_name, name);
  const double left = plan.corner.x(), right = left + place.width / plan.scale;
  int free = place.x - 3 * unit; // of labels
  eachMultiple(left, right, step, [&](double value) {
    const int x = static_cast<int>(plan.px(Eigen::Vector2d(value, 0)).x());
    canvas.fill({x, place.bottom() - length, thin, length}, kStockEdge);
    const int width = textWidth(number(value), text);
    if (x - width / 2 < free || x + width / 2 > place.right() - across_room - unit)
      return;
    drawText(canvas, x - width / 2, row, number(value), text);
    free = x + width / 2 + unit;
  });

  const std::string up_name = up + " [mm]";
  drawText(
      canvas, place.x - unit - textWidth(up_name, name), place.y + unit, up_name, name);
  const double top = plan.corner.y(), bottom = top - place.height / plan.scale;
  eachMultiple(bottom, top, step, [&](double value) {
    const int y = static_cast<int>(plan.px(Eigen::Vector2d(0, value)).y());
    canvas.fill({place.x, y, length, thin}, kStockEdge);
    if (y > place.y + 3 * unit && y < place.bottom() - unit / 2)
      drawText(canvas,
               place.x - unit - textWidth(number(value), text),
               y,
               number(value),
               text);
  });
}

} // namespace pointmill::visual
