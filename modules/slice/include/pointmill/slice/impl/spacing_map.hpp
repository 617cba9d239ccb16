// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/spacing_map.h>

#include <cmath>
#include <utility>

namespace pointmill {

template <typename PointT>
void SpacingMap<PointT>::apply(CellCloud& output)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(this->indices_->size());
  for (const auto i : *this->indices_) {
    const Eigen::Vector3f p = (*this->input_)[i].getVector3fMap();
    if (p.allFinite())
      points.push_back(p);
  }
  const std::size_t finite = points.size();
  if (finite == 0)
    throw DataError("SpacingMap: no point of the input is finite");
  const SpacingField field = mapSpacing(std::move(points), cell_size_, gap_reach_);
  const CellGrid& grid = field.grid;

  output.resize(grid.size());
  output.width = static_cast<std::uint32_t>(grid.columns);
  output.height = static_cast<std::uint32_t>(grid.rows);
  output.is_dense = false;
  std::size_t covered = 0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t at = grid.index(column, row);
      PointCell& cell = output[at];
      cell.x = static_cast<float>(grid.x(column));
      cell.y = static_cast<float>(grid.y(row));
      cell.z = field.spacing[at];
      cell.count = field.count[at];
      cell.setState(std::isfinite(cell.z) ? CellState::Occupied : CellState::Empty);
      covered += std::isfinite(cell.z);
    }

  spacing_ = field.figures;
  this->report_.set("points", static_cast<double>(finite));
  this->report_.set("nan_points", static_cast<double>(this->indices_->size() - finite));
  this->report_.set("covered_cells", static_cast<double>(covered));
  this->report_.set("median_mm", spacing_.median);
  this->report_.set("p99_mm", spacing_.p99);
  this->report_.set("worst_mm", spacing_.worst);
}

} // namespace pointmill
