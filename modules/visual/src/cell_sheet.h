// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"
#include "grid.h"
#include "text.h"

#include <functional>
#include <string>

namespace pointmill::visual {

/// @brief A picture of a map's cells from above (X right, Y up), each a square of one
/// colour, with a title over and a scale bar under them.
class CellSheet {
public:
  using ColourOf = std::function<Rgb(const PointCell&)>;

  /// @param foot room under the cells [px], whose first line begins with the scale bar
  CellSheet(const Grid& grid,
            const std::string& title,
            const ColourOf& colour_of,
            int foot = kFoot);

  Canvas& canvas() { return canvas_; }
  /// @brief Where a cell is drawn; cells that were left out share their neighbour's
  /// place.
  Rect place(int column, int row) const;
  /// @brief Of the line under the cells, for a legend [px].
  int footMiddle() const { return canvas_.height() - foot_ + kFoot / 2; }
  int left() const { return kMargin; }
  int right() const { return canvas_.width() - kMargin; }
  static TextStyle text() { return {19, false, kInk}; }

private:
  static constexpr int kMargin = 36, kHead = 84, kFoot = 72; // px

  int columns_, rows_;
  bool right_, up_; ///< which way columns and rows run in the part
  int left_ = 0, px_ = 1, stride_ = 1;
  int foot_;
  Canvas canvas_;
};

} // namespace pointmill::visual
