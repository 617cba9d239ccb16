// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "text.h"

#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief One line of a legend.
struct LegendItem {
  enum class Mark { Box, Hatched, Line, Dashed, Heights };
  Mark mark;
  Rgb colour;
  std::string text;
};
using Legend = std::vector<LegendItem>;

/// @brief Where a preview's three panels and its texts go [px].
struct Layout {
  /// @param legend_rows lines that every panel keeps for its legend
  Layout(int width, int height, int legend_rows);

  int px(double at_full_size) const; ///< scaled with the picture, at least 1
  TextStyle text(double size, bool bold = false, const Rgb& colour = kInk) const;

  double scale; ///< 1 at 2100 x 900
  int margin;
  Rect title;
  Rect card[3], head[3], picture[3], legend[3];
  Rect ruler, figures;
};

constexpr int kLegendRows = 4; // at most; more items take a second column

/// @brief Lines that a legend of @p items takes.
int legendRows(int items);
void drawLegend(Canvas& canvas, const Layout&, const Rect& place, const Legend& legend);

/// @brief Writes the figures one after the other, in as many lines and as large as the
/// place allows.
void drawFigures(Canvas& canvas,
                 const Layout&,
                 const Rect& place,
                 const std::vector<std::string>& figures);

} // namespace pointmill::visual
