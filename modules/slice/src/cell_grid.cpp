// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/slice/cell_grid.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

namespace {
constexpr double kMostCells = 100e6;
}

CellGrid
CellGrid::covering(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell)
{
  if (!(cell > 0) || !min.allFinite() || !max.allFinite())
    throw ParameterError("CellGrid: the cell size must be above 0 and the box finite");
  const Eigen::Vector2d count = ((max - min) / cell).array().floor() + 1.0;
  if (count.prod() > kMostCells)
    throw ParameterError("CellGrid: more than 100 million cells: choose larger cells");
  CellGrid grid;
  grid.x0 = min.x();
  grid.y0 = min.y();
  grid.cell = cell;
  // Two cells each way at least, so that an organised cloud tells its cell size.
  grid.columns = std::max(2, static_cast<int>(count.x()));
  grid.rows = std::max(2, static_cast<int>(count.y()));
  return grid;
}

CellGrid CellGrid::of(const CellCloud& map)
{
  if (map.width < 2 || map.height < 2 ||
      map.size() != static_cast<std::size_t>(map.width) * map.height)
    throw DataError(
        "the map is not an organised cloud of cells (OccupancyMap makes one)");
  CellGrid grid;
  grid.columns = static_cast<int>(map.width);
  grid.rows = static_cast<int>(map.height);
  const auto &first = map.front(), &last = map.back();
  const double wide = (last.x - first.x) / (grid.columns - 1.0);
  const double deep = (last.y - first.y) / (grid.rows - 1.0);
  if (!(wide > 0) || !(std::abs(wide - deep) <= 1e-3 * wide))
    throw DataError("the map's cells are not square");
  // The longer side knows the cell size to more digits.
  grid.cell = grid.columns > grid.rows ? wide : deep;
  grid.x0 = first.x - 0.5 * grid.cell;
  grid.y0 = first.y - 0.5 * grid.cell;
  return grid;
}

int CellGrid::columnOf(double px) const
{
  return static_cast<int>(std::clamp(std::floor((px - x0) / cell), -1e9, 1e9));
}

int CellGrid::rowOf(double py) const
{
  return static_cast<int>(std::clamp(std::floor((py - y0) / cell), -1e9, 1e9));
}

} // namespace pointmill
