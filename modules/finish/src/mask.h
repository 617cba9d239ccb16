// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace pointmill {

/// Places in XY, as square cells that hold one or lie beside one that does.
class Mask {
public:
  /// @param cell edge of a cell [mm]; wider where there would be too many
  Mask(const std::vector<Eigen::Vector2d>& places, double cell)
  {
    low_ = places.front();
    Eigen::Vector2d high = low_;
    for (const auto& p : places) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    cell_ = std::max(cell, (high - low_).maxCoeff() / kMostCells);
    low_ -= Eigen::Vector2d(1.5 * cell_, 1.5 * cell_); // for the cells beside
    columns_ = cellOf(high).x + 2;
    rows_ = cellOf(high).y + 2;
    holds_.assign(columns_ * rows_, 0);
    for (const auto& p : places) {
      const Cell at = cellOf(p);
      for (std::size_t y = at.y - 1; y <= at.y + 1; ++y)
        for (std::size_t x = at.x - 1; x <= at.x + 1; ++x)
          holds_[y * columns_ + x] = 1;
    }
  }

  bool holds(const Eigen::Vector2d& p) const
  {
    if (p.x() < low_.x() || p.y() < low_.y())
      return false;
    const Cell at = cellOf(p);
    return at.x < columns_ && at.y < rows_ && holds_[at.y * columns_ + at.x];
  }

private:
  static constexpr double kMostCells = 4000; // along a side
  struct Cell {
    std::size_t x, y;
  };
  Cell cellOf(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d at = (p - low_) / cell_;
    return {static_cast<std::size_t>(at.x()), static_cast<std::size_t>(at.y())};
  }

  Eigen::Vector2d low_;
  double cell_;
  std::size_t columns_, rows_;
  std::vector<char> holds_;
};

} // namespace pointmill
