// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <vector>

namespace pointmill::visual {

/// @brief Where things of some widths stand that follow one another in lines, as words
/// do.
struct Flow {
  struct At {
    int x, line;
  };
  /// @param widths,gap,room of each thing, between two of a line, and of a line [px]
  Flow(const std::vector<int>& widths, int gap, int room)
  {
    int x = 0, line = 0;
    for (const int width : widths) {
      if (x > 0 && x + width > room) {
        x = 0;
        ++line;
      }
      at.push_back({x, line});
      x += width + gap;
    }
    lines = at.empty() ? 0 : line + 1;
  }

  std::vector<At> at;
  int lines;
};

} // namespace pointmill::visual
