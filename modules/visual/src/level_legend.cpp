// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "level_legend.h"

#include "level_ground.h"
#include "level_lines.h"

#include <algorithm>

namespace pointmill::visual {
namespace {

using Paint = std::function<void(Canvas&, const Rect&)>;

Eigen::Vector2f left(const Rect& r)
{
  return {static_cast<float>(r.x), static_cast<float>(r.y) + 0.5f * r.height};
}
Eigen::Vector2f right(const Rect& r)
{
  return left(r) + Eigen::Vector2f(static_cast<float>(r.width), 0);
}

Paint box(const Rgb& colour)
{
  return [colour](Canvas& canvas, const Rect& r) {
    canvas.fill(r, kStockEdge);
    canvas.fill({r.x + 1, r.y + 1, r.width - 2, r.height - 2}, colour);
  };
}

Paint stroke(const Rgb& colour, float thickness)
{
  return [colour, thickness](Canvas& canvas, const Rect& r) {
    const Eigen::Vector2f a = left(r), b = right(r);
    canvas.line(a.x(), a.y(), b.x(), b.y(), thickness, colour);
  };
}

void paintOrder(Canvas& canvas, const Rect& r)
{
  for (int x = 0; x < r.width; ++x)
    canvas.fill({r.x + x, r.y + r.height / 4, 1, r.height / 2},
                orderColour(static_cast<float>(x) / static_cast<float>(r.width - 1)));
}

void paintGap(Canvas& canvas, const Rect& r)
{
  for (int y = r.y; y < r.bottom(); ++y)
    for (int x = r.x; x < r.right(); ++x)
      canvas.set(x, y, gapColour(x, y));
}

bool hasGap(const CellCloud& map, double z)
{
  return std::any_of(map.begin(), map.end(), [&](const PointCell& c) {
    return c.getState() == CellState::Gap && !(c.z <= z);
  });
}

bool hasAir(const CellCloud& standing, double z)
{
  return std::any_of(standing.begin(), standing.end(), [&](const PointCell& c) {
    return !(c.z > z + kTouch);
  });
}

} // namespace

LevelLegend::LevelLegend(
    const LevelScene& scene, const LevelMoves& moves, double z, int room, int unit)
    : unit_(unit), flow_({}, 0, 0)
{
  const auto shows = [&](MoveKind kind) {
    return std::any_of(moves.moves.begin(), moves.moves.end(), [&](const auto& m) {
      return m.kind == kind && m.from != m.to;
    });
  };
  const float thickness = lineThickness(unit);
  items_.push_back({"cuts, first to last", 8 * unit, paintOrder});
  if (shows(MoveKind::Entry))
    items_.push_back(
        {"ramp or lead-in", 3 * unit, stroke(kEntryMove, 2.6f * thickness)});
  if (shows(MoveKind::Link))
    items_.push_back({"link or lead-out", 3 * unit, stroke(kLinkMove, thickness)});
  if (shows(MoveKind::Rapid))
    items_.push_back({"rapid", 4 * unit, [=](Canvas& canvas, const Rect& r) {
                        drawRapid(canvas, left(r), right(r), thickness);
                      }});
  if (!moves.entries.empty())
    items_.push_back({"comes down", 2 * unit, [=](Canvas& canvas, const Rect& r) {
                        drawEntry(canvas, (left(r) + right(r)) / 2, thickness);
                      }});
  items_.push_back({"part above", 2 * unit, box(kPartAbove)});
  if (hasGap(*scene.map, z))
    items_.push_back({"gap, protected", 2 * unit, paintGap});
  items_.push_back({"milled here", 2 * unit, box(kSwept)});
  items_.push_back({"stock that stays", 2 * unit, box(kStanding)});
  if (scene.standing && hasAir(*scene.standing, z))
    items_.push_back({"air before", 2 * unit, box(kCutAway)});
  flow_ = Flow(widths(), 2 * unit, room);
}

std::vector<int> LevelLegend::widths() const
{
  std::vector<int> all;
  for (const auto& item : items_)
    all.push_back(item.mark + gap() + textWidth(item.text, style()));
  return all;
}

void LevelLegend::draw(Canvas& canvas, int x, int y) const
{
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const int from = x + flow_.at[i].x;
    const int middle = y + flow_.at[i].line * line() + line() / 2;
    item.paint(canvas, {from, middle - unit_ * 3 / 4, item.mark, unit_ * 3 / 2});
    drawText(canvas, from + item.mark + gap(), middle, item.text, style());
  }
}

} // namespace pointmill::visual
