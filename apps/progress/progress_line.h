// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "progress/progress.h"

#include <cstddef>
#include <memory>
#include <string>

namespace pointmill {

/// @brief `finishing  [######      ]  52 %  0:14, about 0:12 left`, no longer than
/// @p width. Where there is little room the bar goes, then the times.
std::string progressLine(const Progress& progress, int width);

/// @brief While it lives, what is computed is shown in one line of a terminal, which
/// is written again and again. It is shown after a second and gone in the end; where
/// standard error is no terminal there is none.
class ProgressLine {
public:
  explicit ProgressLine(const Watch& watch);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

private:
  void show(const std::string& line);

  std::size_t shown_ = 0; // columns
  std::unique_ptr<ProgressTeller> teller_;
};

} // namespace pointmill
