// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>
#include <pointmill/rough/level_map.h>
#include <pointmill/slice/distance_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

/// One cell of a cutter's footprint and the cutter's height over it.
struct Offset {
  int column, row;
  float height;
};

/// Footprint of a cutter over a grid of `cell` mm whose profile is `height(distance)`,
/// infinite outside. `distance(d)` turns the distance between two cells' centres into
/// the one that counts.
template <typename Height>
std::vector<Offset> footprint(double reach, double cell, Height&& height)
{
  std::vector<Offset> offsets;
  const int n = static_cast<int>(std::ceil(reach / cell)) + 1;
  for (int r = -n; r <= n; ++r)
    for (int c = -n; c <= n; ++c) {
      const double h = height(c * cell, r * cell);
      if (std::isfinite(h))
        offsets.push_back({c, r, static_cast<float>(h)});
    }
  return offsets;
}

/// out(cell) = max over the offsets of in(cell + offset) - height. With `lower` the
/// dual: min over the offsets of in(cell + offset) + height.
std::vector<float> filterMax(const CellGrid& grid,
                             const std::vector<float>& in,
                             const std::vector<Offset>& offsets,
                             unsigned threads)
{
  std::vector<float> out(in.size(), kNothing);
  parallelFor(static_cast<std::size_t>(grid.rows), threads, [&](std::size_t row) {
    float* line = &out[row * grid.columns];
    for (const auto& o : offsets) {
      const int r = static_cast<int>(row) + o.row;
      if (r < 0 || r >= grid.rows)
        continue;
      const float* from = &in[static_cast<std::size_t>(r) * grid.columns];
      const int first = std::max(0, -o.column);
      const int last = std::min(grid.columns, grid.columns - o.column);
      for (int c = first; c < last; ++c)
        line[c] = std::max(line[c], from[c + o.column] - o.height);
    }
  });
  return out;
}

} // namespace

LevelMap::LevelMap(const CellCloud& map,
                   const Tool& tool,
                   double allowance,
                   const StockField& stock,
                   double min_thickness,
                   double min_width,
                   unsigned threads)
    : radius_(tool.radius())
{
  const CellGrid cells = CellGrid::of(map);
  const double cell = cells.cell, half = cell / 2;
  const Tool grown = tool.grown(allowance);

  // The map's grid, extended so that the tool can run round the stock and the part.
  const auto extra = [&](double gap) {
    return std::max(0, static_cast<int>(std::ceil(gap / cell)));
  };
  const double room = grown.radius() + 2 * cell;
  const Stock& box = stock.stock();
  const int left = extra(cells.x0 - box.min.x() + room);
  const int below = extra(cells.y0 - box.min.y() + room);
  const int right = extra(box.max.x() - (cells.x0 + cells.columns * cell) + room);
  const int above = extra(box.max.y() - (cells.y0 + cells.rows * cell) + room);
  grid_ = cells;
  grid_.x0 -= left * cell;
  grid_.y0 -= below * cell;
  grid_.columns += left + right;
  grid_.rows += below + above;

  std::vector<float> part(grid_.size(), kNothing);
  for (int r = 0; r < cells.rows; ++r)
    for (int c = 0; c < cells.columns; ++c) {
      const auto& from = map[cells.index(c, r)];
      if (from.getState() != CellState::Empty)
        part[grid_.index(c + left, r + below)] = from.z;
    }
  // A cell's points may lie anywhere in it; a move between two nodes passes a point up
  // to half a diagonal step nearer than the nearer node does. 1e-4 covers float32.
  const auto keep_away = [&](double dx, double dy) {
    const double bx = std::max(0.0, std::abs(dx) - half);
    const double by = std::max(0.0, std::abs(dy) - half);
    const double d2 = bx * bx + by * by - cell * cell / 2;
    return grown.profile(std::sqrt(std::max(0.0, d2)) - 1e-4);
  };
  lowest_ = filterMax(
      grid_, part, footprint(grown.radius() + 2 * cell, cell, keep_away), threads);
  for (auto& z : lowest_)
    z += static_cast<float>(allowance);

  // The stock on the same grid, less what the tool could not make thinner anyway.
  std::vector<float> standing(grid_.size(), kNothing);
  for (int r = 0; r < grid_.rows; ++r)
    for (int c = 0; c < grid_.columns; ++c)
      standing[grid_.index(c, r)] =
          static_cast<float>(stock.highest(grid_.x(c), grid_.y(r), 0.0));
  // Under the tool for certain: what a pass over the node would cut away.
  const double certain = tool.radius() - std::sqrt(2.0) * stock.cellSize();
  const auto under = [&](double dx, double dy) {
    const double d = std::hypot(dx, dy);
    return d <= std::max(certain, 0.0) ? tool.profile(d)
                                       : std::numeric_limits<double>::infinity();
  };
  if (min_thickness > 0) {
    auto raised = lowest_;
    for (auto& z : raised) // the lower envelope is the upper one of the negative
      z = -z;
    const auto left_over =
        filterMax(grid_, raised, footprint(tool.radius(), cell, under), threads);
    // ... and what is thick only as a skin on a wall.
    std::vector<unsigned char> thin(grid_.size()), core(grid_.size());
    for (std::size_t i = 0; i < standing.size(); ++i)
      thin[i] = !(standing[i] + left_over[i] > min_thickness);
    const double half_width = min_width / 2 / cell;
    const auto to_thin = distanceField(thin, grid_.columns, grid_.rows);
    for (std::size_t i = 0; i < standing.size(); ++i)
      core[i] = to_thin[i] > half_width;
    const auto to_core = distanceField(core, grid_.columns, grid_.rows);
    for (std::size_t i = 0; i < standing.size(); ++i)
      if (thin[i] || to_core[i] > half_width)
        standing[i] = kNothing;
  }
  const auto flat = [&](double dx, double dy) {
    return std::isfinite(under(dx, dy)) ? 0.0 : std::numeric_limits<double>::infinity();
  };
  stock_top_ =
      filterMax(grid_, standing, footprint(tool.radius(), cell, flat), threads);
}

} // namespace pointmill
