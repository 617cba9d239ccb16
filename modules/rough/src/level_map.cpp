// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>
#include <pointmill/rough/level_map.h>
#include <pointmill/slice/cell_regions.h>
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

/// Footprint of a cutter over a grid of `cell` mm whose profile is `height(dx, dy)`,
/// infinite outside.
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

/// out(cell) = max over the offsets of in(cell + offset) - height.
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
                   const PointIndex* part,
                   const StockField& stock,
                   const Clearing& clearing,
                   unsigned threads)
    : threads_(threads), tool_(clearing.tool), stock_(stock.stock()), part_(part),
      keep_out_(clearing.keep_out), allowance_(clearing.allowance)
{
  const CellGrid cells = CellGrid::of(map);
  // So that the tool can run round the stock and the part.
  extend(cells, stock.stock(), tool_.radius() + clearing.allowance + 2 * cells.cell);
  const double r = tool_.tipRadius() + allowance_;
  wider_ = std::sqrt(r * r + grid_.cell * grid_.cell / 2) - r + 1e-4;
  if (part)
    dropOnPoints();
  else
    dropOnCells(map, clearing.allowance);
  keepOut();
  measureStock(stock, clearing);
}

void LevelMap::extend(const CellGrid& cells, const Stock& box, double room)
{
  const double cell = cells.cell;
  const auto extra = [&](double gap) {
    return std::max(0, static_cast<int>(std::ceil((gap + room) / cell)));
  };
  const int left = extra(cells.x0 - box.min.x());
  const int below = extra(cells.y0 - box.min.y());
  grid_ = cells;
  grid_.x0 -= left * cell;
  grid_.y0 -= below * cell;
  grid_.columns += left + extra(box.max.x() - (cells.x0 + cells.columns * cell));
  grid_.rows += below + extra(box.max.y() - (cells.y0 + cells.rows * cell));
}

void LevelMap::dropOnCells(const CellCloud& map, double allowance)
{
  const Tool grown = tool_.grown(allowance);
  const double cell = grid_.cell, half = cell / 2;
  std::vector<float> part(grid_.size(), kNothing);
  for (const auto& from : map)
    if (from.getState() != CellState::Empty)
      part[grid_.index(grid_.columnOf(from.x), grid_.rowOf(from.y))] = from.z;
  // A cell's points may lie anywhere in it; a place between nodes is up to half a
  // diagonal nearer to a point than the nearest node. 1e-4 covers float32.
  const auto keep_away = [&](double dx, double dy) {
    const double bx = std::max(0.0, std::abs(dx) - half);
    const double by = std::max(0.0, std::abs(dy) - half);
    const double d2 = bx * bx + by * by - cell * cell / 2;
    return grown.profile(std::sqrt(std::max(0.0, d2)) - 1e-4);
  };
  lowest_ = filterMax(
      grid_, part, footprint(grown.radius() + 2 * cell, cell, keep_away), threads_);
  for (auto& z : lowest_)
    z += static_cast<float>(allowance);
}

void LevelMap::dropOnPoints()
{
  const Tool grown = tool_.grown(allowance_ + wider_);
  lowest_.assign(grid_.size(), kNothing);
  const auto rows = static_cast<std::size_t>(grid_.rows);
  parallelFor(rows, threads_, {0.0, 0.7}, [&](std::size_t row) {
    std::vector<Contact> contacts(static_cast<std::size_t>(grid_.columns));
    part_->dropRow(grown,
                   {grid_.x(0), grid_.y(static_cast<int>(row))},
                   {grid_.cell, 0},
                   contacts.size(),
                   contacts.data());
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (contacts[c].touches())
        lowest_[row * contacts.size() + c] =
            static_cast<float>(contacts[c].tip + allowance_ + wider_);
  });
}

void LevelMap::keepOut()
{
  if (keep_out_.empty())
    return;
  without_zones_ = lowest_;
  const CutterProfile grown = tool_.grown(wider_).profile();
  for (int row = 0; row < grid_.rows; ++row)
    for (int column = 0; column < grid_.columns; ++column) {
      float& z = lowest_[grid_.index(column, row)];
      const double clear = keep_out_.lowest(grown, grid_.x(column), grid_.y(row));
      z = std::max(z, static_cast<float>(clear + wider_));
    }
}

double LevelMap::lowestAt(const Eigen::Vector2d& p) const
{
  if (!part_)
    return lowestAlong(p, p);
  const double more = allowance_ + wider_;
  return std::max(part_->drop(tool_.grown(more), p.x(), p.y()).tip + more,
                  keep_out_.lowest(tool_.grown(wider_), p.x(), p.y()) + wider_);
}

double LevelMap::lowestAlongPoints(const Eigen::Vector2d& a,
                                   const Eigen::Vector2d& b) const
{
  if (!part_)
    return lowestAlong(a, b);
  return std::max(
      part_->dropAlong(tool_.grown(allowance_), a.x(), a.y(), b.x(), b.y()) +
          allowance_,
      keep_out_.lowestAlong(tool_, a.x(), a.y(), b.x(), b.y()));
}

std::vector<float> LevelMap::reach(bool zones, bool sure) const
{
  const double certain =
      std::max(0.0, tool_.radius() - (sure ? std::sqrt(0.5) * grid_.cell : 0.0));
  const auto under = [&](double dx, double dy) {
    const double d = std::hypot(dx, dy);
    return d <= certain ? tool_.profile(d) : std::numeric_limits<double>::infinity();
  };
  auto depth = zones || keep_out_.empty() ? lowest_ : without_zones_;
  for (auto& z : depth) // a lower envelope is the upper one of the negative
    z = -z;
  depth =
      filterMax(grid_, depth, footprint(tool_.radius(), grid_.cell, under), threads_);
  for (auto& z : depth)
    z = -z;
  return depth;
}

double LevelMap::lowestAlong(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
{
  constexpr double kOn = 1e-7; // nodes; nearer to a line of nodes is on it
  // In nodes, from the end with the lower column.
  Eigen::Vector2d from((a.x() - grid_.x(0)) / grid_.cell,
                       (a.y() - grid_.y(0)) / grid_.cell);
  Eigen::Vector2d to((b.x() - grid_.x(0)) / grid_.cell,
                     (b.y() - grid_.y(0)) / grid_.cell);
  if (to.x() < from.x())
    std::swap(from, to);
  const auto down = [&](double v) { return static_cast<int>(std::floor(v + kOn)); };
  const auto up = [&](double v) { return static_cast<int>(std::ceil(v - kOn)); };
  const Node low{down(from.x()), down(std::min(from.y(), to.y()))};
  const Node high{up(to.x()), up(std::max(from.y(), to.y()))};
  if (!has(low) || !has(high))
    return std::numeric_limits<double>::infinity();
  const double slope =
      to.x() > from.x() ? (to.y() - from.y()) / (to.x() - from.x()) : 0;
  double highest = kNothing;
  for (int column = low.column; column < std::max(high.column, low.column + 1);
       ++column) {
    // The rows of nodes round what lies between this column and the next.
    double y0 = from.y(), y1 = to.y();
    if (to.x() > from.x()) {
      y0 = from.y() + slope * (std::max<double>(column, from.x()) - from.x());
      y1 = from.y() + slope * (std::min<double>(column + 1, to.x()) - from.x());
    }
    const int first = std::max(low.row, down(std::min(y0, y1)));
    const int last = std::min(high.row, up(std::max(y0, y1)));
    for (int row = first; row <= last; ++row) {
      const std::size_t i = grid_.index(column, row);
      highest = std::max<double>(highest, lowest_[i]);
      if (column < high.column)
        highest = std::max<double>(highest, lowest_[i + 1]);
    }
  }
  return highest;
}

void LevelMap::measureStock(const StockField& stock, const Clearing& clearing)
{
  const double cell = grid_.cell;
  standing_.assign(grid_.size(), kNothing);
  for (int r = 0; r < grid_.rows; ++r)
    for (int c = 0; c < grid_.columns; ++c)
      standing_[grid_.index(c, r)] =
          static_cast<float>(stock.highest(grid_.x(c), grid_.y(r), cell / 4));
  auto worth = standing_;
  if (clearing.min_thickness > 0) {
    // Leave what is not much thicker than the tool would leave it ...
    const auto left_over = reach(true, true);
    std::vector<unsigned char> thin(grid_.size()), core(grid_.size());
    for (std::size_t i = 0; i < worth.size(); ++i)
      thin[i] = !(worth[i] - left_over[i] > clearing.min_thickness);
    // ... and what is thick only as a skin on a wall.
    const double half_width = clearing.min_width / 2 / cell;
    const auto to_thin = distanceField(thin, grid_.columns, grid_.rows);
    for (std::size_t i = 0; i < worth.size(); ++i)
      core[i] = to_thin[i] > half_width;
    const auto to_core = distanceField(core, grid_.columns, grid_.rows);
    for (std::size_t i = 0; i < worth.size(); ++i)
      if (thin[i] || to_core[i] > half_width)
        worth[i] = kNothing;
  }
  const double end = std::max(0.0, endRadius() - std::sqrt(2.0) * stock.cellSize());
  const auto under_end = [&](double dx, double dy) {
    return std::hypot(dx, dy) <= end ? 0.0 : std::numeric_limits<double>::infinity();
  };
  stock_top_ =
      filterMax(grid_, worth, footprint(endRadius(), cell, under_end), threads_);
}

std::vector<int> LevelMap::regions(double floor) const
{
  std::vector<unsigned char> mask(grid_.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
    mask[i] = stock_top_[i] > std::max<double>(lowest_[i], floor) + 1e-3;
  const auto distance = distanceField(mask, grid_.columns, grid_.rows);
  const double reach = tool_.radius() / grid_.cell + 1;
  for (std::size_t i = 0; i < mask.size(); ++i)
    mask[i] = distance[i] <= reach;

  std::vector<int> region(grid_.size(), 0);
  int count = 0;
  for (const auto& cells : cellRegions(grid_, std::move(mask), Connected::Corners)) {
    ++count;
    for (const auto at : cells)
      region[at] = count;
  }
  return region;
}

} // namespace pointmill
