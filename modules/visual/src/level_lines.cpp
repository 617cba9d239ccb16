// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "level_lines.h"

#include <cmath>

namespace pointmill::visual {
namespace {

void line(Canvas& canvas,
          const Eigen::Vector2f& a,
          const Eigen::Vector2f& b,
          float thickness,
          const Rgb& colour)
{
  canvas.line(a.x(), a.y(), b.x(), b.y(), thickness, colour);
}

} // namespace

Rgb orderColour(float t)
{
  constexpr Rgb stops[] = {
      hex(0x440154), hex(0x414487), hex(0x2A788E), hex(0x22A884), hex(0x7AD151)};
  const float s = std::clamp(t, 0.f, 1.f) * 4.f;
  const int i = std::min(static_cast<int>(s), 3);
  return mix(stops[i], stops[i + 1], s - static_cast<float>(i));
}

void drawRapid(Canvas& canvas,
               const Eigen::Vector2f& from,
               const Eigen::Vector2f& to,
               float thickness)
{
  const float length = (to - from).norm();
  const float dash = 4.5f * thickness;
  for (float begin = 0; begin < length; begin += 1.8f * dash) {
    const float end = std::min(begin + dash, length);
    line(canvas,
         from + (to - from) * (begin / length),
         from + (to - from) * (end / length),
         0.5f * thickness,
         kRapid);
  }
}

void drawEntry(Canvas& canvas, const Eigen::Vector2f& at, float thickness)
{
  line(canvas, at, at, 4.2f * thickness, kRapid);
  line(canvas, at, at, 2.6f * thickness, kPage);
}

void drawMoves(Canvas& canvas,
               const Plan& plan,
               const LevelMoves& moves,
               float thickness)
{
  moves.each(MoveKind::Entry, [&](const LevelMove& m) {
    line(canvas, plan.px(m.from), plan.px(m.to), 2.6f * thickness, kEntryMove);
  });
  const double all = std::max(moves.length, 1e-9);
  for (const LevelMove& m : moves.moves) {
    const Eigen::Vector2f a = plan.px(m.from), b = plan.px(m.to);
    if (m.kind == MoveKind::Link)
      line(canvas, a, b, thickness, kLinkMove);
    else if (m.kind != MoveKind::Rapid) {
      const double length = (m.to - m.from).norm();
      canvas.line(a.x(),
                  a.y(),
                  b.x(),
                  b.y(),
                  m.kind == MoveKind::Cut ? thickness : 0.5f * thickness,
                  [&](float t) {
                    return orderColour(
                        static_cast<float>((m.begun + t * length) / all));
                  });
    }
  }
  moves.each(MoveKind::Rapid, [&](const LevelMove& m) {
    drawRapid(canvas, plan.px(m.from), plan.px(m.to), thickness);
  });
  for (const auto& at : moves.entries)
    drawEntry(canvas, plan.px(at), thickness);
}

} // namespace pointmill::visual
