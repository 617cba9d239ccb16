// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "layout.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {
constexpr int kLegendLine = 27;
constexpr int kFooter = 88;
constexpr int kFigureRows = 3;

struct Figure {
  int x, row;
  std::string text;
};

/// The figures one after the other, in @p rows lines of about the same length if they
/// fit there, else in more.
std::vector<Figure> placeFigures(const std::vector<std::string>& figures,
                                 int width,
                                 int rows,
                                 const TextStyle& style)
{
  const int gap = 2 * style.size;
  std::vector<Figure> placed;
  std::vector<int> widths;
  int total = 0;
  for (const auto& figure : figures) {
    placed.push_back({0, 0, fitText(figure, width, style)});
    widths.push_back(textWidth(placed.back().text, style));
    total += widths.back() + gap;
  }
  int x = 0, row = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    // Half of it over the fair share is the next line's.
    if (x > 0 && (x + widths[i] > width ||
                  (row + 1 < rows && x + widths[i] / 2 > total / rows))) {
      x = 0;
      ++row;
    }
    placed[i].x = x;
    placed[i].row = row;
    x += widths[i] + gap;
  }
  return placed;
}

} // namespace

Layout::Layout(int width, int height, int legend_rows)
    : scale(std::min(width / 2100.0, height / 900.0)), margin(px(28))
{
  title = {margin, px(20), width - 2 * margin, px(46)};
  const int gap = px(20), top = title.bottom() + px(12);
  const int footer = height - px(kFooter) - px(8);
  const int card_width = (width - 2 * margin - 2 * gap) / 3;
  const int legend_height = legend_rows * px(kLegendLine);
  for (int i = 0; i < 3; ++i) {
    card[i] = {margin + i * (card_width + gap), top, card_width, footer - top};
    const int inner = px(18);
    head[i] = {card[i].x + inner, top + px(10), card_width - 2 * inner, px(34)};
    legend[i] = {card[i].x + inner,
                 card[i].bottom() - legend_height - px(12),
                 card_width - 2 * inner,
                 legend_height};
    picture[i] = {card[i].x + px(8),
                  head[i].bottom() + px(2),
                  card_width - 2 * px(8),
                  legend[i].y - head[i].bottom() - px(8)};
  }
  ruler = {margin, footer, px(420), px(kFooter)};
  figures = {ruler.right() + px(20),
             footer,
             width - margin - ruler.right() - px(20),
             px(kFooter)};
}

int Layout::px(double at_full_size) const
{
  return std::max(1, static_cast<int>(std::lround(at_full_size * scale)));
}

TextStyle Layout::text(double size, bool bold, const Rgb& colour) const
{
  return {std::max(8, px(size)), bold, colour};
}

int legendRows(int items)
{
  return items <= kLegendRows ? std::max(items, 1)
                              : std::min(kLegendRows, (items + 1) / 2);
}

void drawLegend(Canvas& canvas,
                const Layout& layout,
                const Rect& place,
                const Legend& legend)
{
  const int line = layout.px(kLegendLine);
  const int rows = std::max(1, place.height / line);
  const int count = static_cast<int>(legend.size());
  const int columns = count > rows ? 2 : 1;
  const int shown = std::min(count, rows * columns);
  const int width = place.width / columns;
  const TextStyle style = layout.text(19);
  const int mark = layout.px(38), gap = layout.px(12), box = layout.px(15);
  for (int i = 0; i < shown; ++i) {
    const LegendItem& item = legend[i];
    const int x = place.x + i / rows * width;
    const int y = place.y + i % rows * line + line / 2;
    const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
    const auto thick = static_cast<float>(layout.px(4));
    switch (item.mark) {
    case LegendItem::Mark::Box:
    case LegendItem::Mark::Hatched:
      canvas.fill({x, y - box / 2, mark, box}, item.colour);
      if (item.mark == LegendItem::Mark::Hatched)
        for (int v = 0; v < box; ++v)
          for (int u = 0; u < mark; ++u)
            if ((u + v) / 2 % 3 == 0)
              canvas.set(x + u, y - box / 2 + v, mix(item.colour, kPage, 0.45f));
      break;
    case LegendItem::Mark::Line:
      canvas.fill({x, y - layout.px(4) / 2, mark, layout.px(4)}, item.colour);
      break;
    case LegendItem::Mark::Dashed:
      for (int k = 0; k < 3; ++k)
        canvas.line(fx + k * 0.38f * mark,
                    fy,
                    fx + (k * 0.38f + 0.22f) * mark,
                    fy,
                    0.6f * thick,
                    item.colour);
      break;
    case LegendItem::Mark::Heights:
      for (int u = 0; u < mark * 3; ++u)
        canvas.fill({x + u, y - box / 2, 1, box},
                    heightColour(static_cast<float>(u) / static_cast<float>(3 * mark)));
      break;
    }
    const int used = item.mark == LegendItem::Mark::Heights ? 3 * mark : mark;
    std::string text = item.text;
    if (i + 1 == shown && shown < count)
      text += ", and " + std::to_string(count - shown) + " more";
    drawText(
        canvas, x + used + gap, y, fitText(text, width - used - 2 * gap, style), style);
  }
}

void drawFigures(Canvas& canvas,
                 const Layout& layout,
                 const Rect& place,
                 const std::vector<std::string>& figures)
{
  // One line if they stay readable, else more of about the same length.
  for (int rows = 1; rows <= kFigureRows; ++rows)
    for (double size = 25; size >= (rows == 1 ? 20 : 16); size -= 1) {
      const TextStyle style = layout.text(size);
      const bool last = rows == kFigureRows && size == 16;
      const std::vector<Figure> placed =
          placeFigures(figures, place.width, rows, style);
      if (!last && (placed.empty() ? 0 : placed.back().row + 1) > rows)
        continue;
      const int used = placed.empty() ? 0 : std::min(rows, placed.back().row + 1);
      const int line = style.size * 3 / 2;
      const int top = place.y + (place.height - used * line) / 2;
      for (const Figure& figure : placed) {
        if (figure.row >= used)
          continue; // more than there is room for
        const int middle = top + figure.row * line + line / 2;
        drawText(canvas, place.x + figure.x, middle, figure.text, style);
        if (figure.x > 0)
          canvas.fill({place.x + figure.x - style.size,
                       middle - style.size / 2,
                       layout.px(2),
                       style.size},
                      kRule);
      }
      return;
    }
}

} // namespace pointmill::visual
