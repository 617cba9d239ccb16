// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "layer_gauge.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pointmill {
namespace {

/// A layer counts that is as wide and long as this share of the diameter. Half of it
/// will do: the other half may lie in rows that another thread cuts.
constexpr double kShare = 0.125;

} // namespace

double LayerGauge::thickness(const std::vector<LoweredCell>& lowered,
                             double diameter,
                             double cell)
{
  if (lowered.empty())
    return 0;
  int row0 = lowered.front().row, row1 = row0;
  int column0 = lowered.front().column, column1 = column0;
  for (const auto& c : lowered) {
    row0 = std::min(row0, c.row);
    row1 = std::max(row1, c.row);
    column0 = std::min(column0, c.column);
    column1 = std::max(column1, c.column);
  }
  const auto width = static_cast<std::size_t>(column1 - column0 + 1);
  box_.assign(width * static_cast<std::size_t>(row1 - row0 + 1), 0.0);
  for (const auto& c : lowered)
    box_[static_cast<std::size_t>(c.row - row0) * width +
         static_cast<std::size_t>(c.column - column0)] += c.depth;

  blocks_.clear(); // of two by two cells: as thick as the thinnest
  for (std::size_t i = width + 1; i < box_.size(); ++i)
    if (i % width != 0 && box_[i] > 0)
      blocks_.push_back(
          std::min({box_[i], box_[i - 1], box_[i - width], box_[i - width - 1]}));
  const double side = kShare * diameter / cell;
  const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(side * side / 2)));
  if (blocks_.size() < n)
    return 0;
  const auto nth = blocks_.begin() + static_cast<std::ptrdiff_t>(n - 1);
  std::nth_element(blocks_.begin(), nth, blocks_.end(), std::greater<>());
  return *nth;
}

} // namespace pointmill
