// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "key.h"

namespace pointmill::visual {

Key::Key(std::vector<Item> items, int room, int unit)
    : unit_(unit), items_(std::move(items)), flow_(widths(), 2 * unit, room)
{
}

std::vector<int> Key::widths() const
{
  std::vector<int> all;
  for (const auto& item : items_)
    all.push_back(item.mark + gap() + textWidth(item.text, style()));
  return all;
}

void Key::draw(Canvas& canvas, int x, int y) const
{
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const int from = x + flow_.at[i].x;
    const int middle = y + flow_.at[i].line * line() + line() / 2;
    item.paint(canvas, {from, middle - unit_ * 3 / 4, item.mark, unit_ * 3 / 2});
    drawText(canvas, from + item.mark + gap(), middle, item.text, style());
  }
}

Key::Paint paintBox(const Rgb& colour)
{
  return [colour](Canvas& canvas, const Rect& r) {
    canvas.fill(r, kStockEdge);
    canvas.fill({r.x + 1, r.y + 1, r.width - 2, r.height - 2}, colour);
  };
}

Key::Paint paintStroke(const Rgb& colour, float thickness)
{
  return [colour, thickness](Canvas& canvas, const Rect& r) {
    const auto y = static_cast<float>(r.y) + 0.5f * static_cast<float>(r.height);
    canvas.line(static_cast<float>(r.x),
                y,
                static_cast<float>(r.right()),
                y,
                thickness,
                colour);
  };
}

} // namespace pointmill::visual
