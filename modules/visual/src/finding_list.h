// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <pointmill/visual/finding_picture.h>

namespace pointmill::visual {

/// @brief The findings as a list: number, code, place in the program, and text.
class FindingList {
public:
  /// @param width of the list [px]; a wide one has two columns
  FindingList(const FindingScene& scene, int width, int unit);

  int height() const;
  void draw(Canvas& canvas, const Rect& card) const;

private:
  struct Entry {
    std::size_t number;
    bool warning;
    std::string code, where;
    std::vector<std::string> text;
  };
  int heightOf(const Entry& entry) const;
  /// The first entry of the second column.
  std::size_t split() const;

  int unit_, columns_, column_width_;
  std::size_t left_out_ = 0;
  std::vector<Entry> entries_;
};

} // namespace pointmill::visual
