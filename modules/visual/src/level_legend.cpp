// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "level_legend.h"

#include "level_ground.h"
#include "level_lines.h"

#include <algorithm>

namespace pointmill::visual {
namespace {

Eigen::Vector2f left(const Rect& r)
{
  return {static_cast<float>(r.x), static_cast<float>(r.y) + 0.5f * r.height};
}
Eigen::Vector2f right(const Rect& r)
{
  return left(r) + Eigen::Vector2f(static_cast<float>(r.width), 0);
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

Key levelLegend(
    const LevelScene& scene, const LevelMoves& moves, double z, int room, int unit)
{
  std::vector<Key::Item> items;
  const auto shows = [&](MoveKind kind) {
    return std::any_of(moves.moves.begin(), moves.moves.end(), [&](const auto& m) {
      return m.kind == kind && m.from != m.to;
    });
  };
  const float thickness = lineThickness(unit);
  items.push_back({"cuts, first to last", 8 * unit, paintOrder});
  if (shows(MoveKind::Entry))
    items.push_back(
        {"ramp or lead-in", 3 * unit, paintStroke(kEntryMove, 2.6f * thickness)});
  if (shows(MoveKind::Link))
    items.push_back({"link or lead-out", 3 * unit, paintStroke(kLinkMove, thickness)});
  if (shows(MoveKind::Rapid))
    items.push_back({"rapid", 4 * unit, [=](Canvas& canvas, const Rect& r) {
                       drawRapid(canvas, left(r), right(r), thickness);
                     }});
  if (!moves.entries.empty())
    items.push_back({"comes down", 2 * unit, [=](Canvas& canvas, const Rect& r) {
                       drawEntry(canvas, (left(r) + right(r)) / 2, thickness);
                     }});
  items.push_back({"part above", 2 * unit, paintBox(kPartAbove)});
  if (hasGap(*scene.map, z))
    items.push_back({"gap, protected", 2 * unit, paintGap});
  items.push_back({"milled here", 2 * unit, paintBox(kSwept)});
  items.push_back({"stock that stays", 2 * unit, paintBox(kStanding)});
  if (scene.standing && hasAir(*scene.standing, z))
    items.push_back({"air before", 2 * unit, paintBox(kCutAway)});
  return {std::move(items), room, unit};
}

} // namespace pointmill::visual
