// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "grid.h"

#include <pointmill/common/error.h>

#include <cmath>

namespace pointmill::visual {

Grid::Grid(const CellCloud& cells, const std::string& what)
    : cells_(cells), columns_(static_cast<int>(cells.width)),
      rows_(static_cast<int>(cells.height))
{
  if (cells.empty())
    throw DataError(what + " is empty");
  if (columns_ < 2 || rows_ < 2 ||
      cells.size() != static_cast<std::size_t>(cells.width) * cells.height)
    throw DataError(what + " is not organised in columns and rows, two at least");
  const PointCell& first = cells.front();
  const PointCell& last = cells.back();
  first_x_ = first.x;
  first_y_ = first.y;
  step_x_ = (static_cast<double>(last.x) - first.x) / (columns_ - 1);
  step_y_ = (static_cast<double>(last.y) - first.y) / (rows_ - 1);
  if (!std::isfinite(step_x_) || !std::isfinite(step_y_) || step_x_ == 0.0 ||
      step_y_ == 0.0)
    throw DataError(what + " has cells without a place");
}

Eigen::AlignedBox3d Grid::box() const
{
  Eigen::AlignedBox3d box;
  for (int r = 0; r < rows_; ++r)
    for (int c = 0; c < columns_; ++c)
      if (std::isfinite(cell(c, r).z))
        box.extend(Eigen::Vector3d(x(c), y(r), cell(c, r).z));
  return box;
}

} // namespace pointmill::visual
