// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "ruler.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace pointmill::visual {

double niceLength(double limit)
{
  if (!(limit > 0.0) || !std::isfinite(limit))
    return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  const double first = limit / decade;
  return decade * (first >= 5 ? 5 : first >= 2 ? 2 : 1);
}

std::string number(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::lround(value * 100.0) / 100.0;
  return text.str();
}

int drawScaleBar(
    Canvas& canvas, int x, int y, int room, double scale, const TextStyle& style)
{
  const double length = niceLength(room / scale);
  const auto px = static_cast<float>(length * scale);
  const auto left = static_cast<float>(x), middle = static_cast<float>(y);
  const float tick = 0.35f * static_cast<float>(style.size);
  const float thick = std::max(1.5f, 0.11f * static_cast<float>(style.size));
  canvas.line(left, middle, left + px, middle, thick, style.colour);
  for (const float end : {left, left + px})
    canvas.line(end, middle - tick, end, middle + tick, thick, style.colour);
  const int gap = style.size / 2;
  const int label = x + static_cast<int>(std::lround(px)) + gap;
  return label - x + drawText(canvas, label, y, number(length) + " mm", style);
}

void drawAxes(
    Canvas& canvas, const Camera& camera, int x, int y, float radius, TextStyle style)
{
  const struct {
    const char* name;
    Eigen::Vector3d axis;
    Rgb colour;
  } axes[] = {{"X", Eigen::Vector3d::UnitX(), kOccupied},
              {"Y", Eigen::Vector3d::UnitY(), hex(0x00805E)},
              {"Z", Eigen::Vector3d::UnitZ(), hex(0x0072B2)}};
  const auto cx = static_cast<float>(x), cy = static_cast<float>(y);
  for (const auto& axis : axes) {
    const Eigen::Vector3f v = camera.toView(axis.axis);
    const float ex = cx + 0.72f * radius * v.x(), ey = cy - 0.72f * radius * v.y();
    const float thick = std::max(1.5f, 0.05f * radius);
    canvas.line(cx, cy, ex, ey, thick, axis.colour);
    style.colour = axis.colour;
    style.bold = true;
    const float flat = std::max(v.head<2>().norm(), 1e-6f);
    const float out = 0.62f * static_cast<float>(style.size);
    const float tx = ex + v.x() / flat * out, ty = ey - v.y() / flat * out;
    drawText(canvas,
             static_cast<int>(std::lround(tx)) - textWidth(axis.name, style) / 2,
             static_cast<int>(std::lround(ty)),
             axis.name,
             style);
  }
}

} // namespace pointmill::visual
