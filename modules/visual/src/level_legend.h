// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "flow.h"
#include "level_moves.h"
#include "text.h"

#include <pointmill/visual/level_picture.h>

#include <functional>
#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief Says what the colours of a level's picture mean: those that it shows.
class LevelLegend {
public:
  /// @param unit [px] that all sizes follow; a text is twice as high
  LevelLegend(
      const LevelScene& scene, const LevelMoves& moves, double z, int room, int unit);

  int height() const { return flow_.lines * line(); }
  /// @brief Draws it with its upper left corner at (x, y).
  void draw(Canvas& canvas, int x, int y) const;

private:
  struct Item {
    std::string text;
    int mark; ///< width [px]
    /// Draws the mark into a rectangle.
    std::function<void(Canvas&, const Rect&)> paint;
  };
  int line() const { return 3 * unit_; }
  int gap() const { return unit_ * 2 / 3; }
  TextStyle style() const { return {2 * unit_, false, kInk}; }
  std::vector<int> widths() const;

  int unit_;
  std::vector<Item> items_;
  Flow flow_;
};

} // namespace pointmill::visual
