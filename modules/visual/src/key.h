// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "flow.h"
#include "text.h"

#include <functional>
#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief Says what the marks of a picture mean: a sample of each and its meaning, one
/// after the other as words flow.
class Key {
public:
  /// @brief Draws a sample into a rectangle.
  using Paint = std::function<void(Canvas&, const Rect&)>;
  struct Item {
    std::string text;
    int mark; ///< width of the sample [px]
    Paint paint;
  };

  /// @param room width of a line [px]
  /// @param unit [px] that all sizes follow; a text is twice as high
  Key(std::vector<Item> items, int room, int unit);

  int height() const { return flow_.lines * line(); }
  /// @brief Draws it with its upper left corner at (x, y).
  void draw(Canvas& canvas, int x, int y) const;

private:
  int line() const { return 3 * unit_; }
  int gap() const { return unit_ * 2 / 3; }
  TextStyle style() const { return {2 * unit_, false, kInk}; }
  std::vector<int> widths() const;

  int unit_;
  std::vector<Item> items_;
  Flow flow_;
};

/// @brief A rectangle of a colour with an edge.
Key::Paint paintBox(const Rgb& colour);
/// @brief A level line.
Key::Paint paintStroke(const Rgb& colour, float thickness);

} // namespace pointmill::visual
