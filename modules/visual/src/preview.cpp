// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas.h"
#include "canvas_png.h"
#include "layout.h"
#include "panels.h"
#include "ruler.h"
#include "text.h"

#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>
#include <pointmill/visual/preview.h>

#include <algorithm>

namespace pointmill {

namespace {

using namespace visual;

void drawRuler(Canvas& canvas, const Layout& layout, const View& view)
{
  const Rect& place = layout.ruler;
  const int radius = layout.px(46);
  drawAxes(canvas,
           view.camera,
           place.x + radius,
           place.y + place.height * 13 / 20,
           static_cast<float>(radius),
           layout.text(17));
  drawScaleBar(canvas,
               place.x + 2 * radius + layout.px(26),
               place.y + place.height / 2,
               layout.px(190),
               view.camera.scale / Frame::kSuper,
               layout.text(20));
}

void drawAbsence(Canvas& canvas, const Layout& layout, const Rect& place)
{
  const TextStyle style = layout.text(20, false, kFaintInk);
  const std::string text = "none";
  drawText(canvas,
           place.x + (place.width - textWidth(text, style)) / 2,
           place.y + place.height / 2,
           text,
           style);
}

} // namespace

void writePreview(const std::string& path,
                  const PreviewScene& scene,
                  int width,
                  int height)
{
  checkRange("preview", "width", width, "px", {640, 8000});
  checkRange("preview", "height", height, "px", {360, 8000});
  View view(scene);
  const Legend legends[3] = {scanLegend(view), pathLegend(view), milledLegend(view)};
  int rows = 1;
  for (const Legend& legend : legends)
    rows = std::max(rows, legendRows(static_cast<int>(legend.size())));
  const Layout layout(width, height, rows);
  view.aim(layout.picture[0].width, layout.picture[0].height, layout.scale);

  Canvas canvas(width, height, kPage);
  const TextStyle title = layout.text(36, true);
  drawText(canvas,
           layout.title.x,
           layout.title.y + layout.title.height / 2,
           fitText(scene.title, layout.title.width, title),
           title);
  Raster (*const paint[3])(const View&) = {scanPanel, pathPanel, milledPanel};
  const char* const names[3] = {"scan", "tool paths", "milled part"};
  for (int i = 0; i < 3; ++i) {
    const WorkStep step({i / 3.0, (i + 1) / 3.0});
    canvas.fillRound(layout.card[i], static_cast<float>(layout.px(14)), kCard);
    paint[i](view).copyTo(canvas, layout.picture[i].x, layout.picture[i].y);
    drawText(canvas,
             layout.head[i].x,
             layout.head[i].y + layout.head[i].height / 2,
             names[i],
             layout.text(25, true));
    drawLegend(canvas, layout, layout.legend[i], legends[i]);
    if (legends[i].empty())
      drawAbsence(canvas, layout, layout.picture[i]);
  }
  drawRuler(canvas, layout, view);
  drawFigures(canvas, layout, layout.figures, scene.figures);
  writePng(path, canvas);
}

} // namespace pointmill
