// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"
#include "text.h"

#include <string>
#include <utility>
#include <vector>

namespace pointmill::visual {

/// @brief A legend in one line that ends at @p right [px]: the first of @p items stands
/// last, each with a square of its colour before it.
void drawSwatches(Canvas& canvas,
                  int right,
                  int middle,
                  const std::vector<std::pair<Rgb, std::string>>& items,
                  const TextStyle& style);

} // namespace pointmill::visual
