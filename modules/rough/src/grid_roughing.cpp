// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stay_down.h"
#include "stretches.h"

#include <pointmill/common/error.h>
#include <pointmill/rough/grid_roughing.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Places a cell apart from `first` on, up to the one that reaches `last`.
std::vector<double> places(double first, double cell, double last)
{
  std::vector<double> all{first};
  while (all.back() < last - 1e-9)
    all.push_back(first + static_cast<double>(all.size()) * cell);
  return all;
}

/// One row of moves, from place to place along it.
class GridRow {
public:
  GridRow(const Level& level, double y, std::vector<double> x, double climb)
      : level_(level), y_(y), x_(std::move(x))
  {
    for (int i = 0; i < moves(); ++i) {
      const double z = std::max(level.z(), level.map().lowestAlong(at(i), at(i + 1)));
      height_.push_back(
          z < level.z() + climb ? z : std::numeric_limits<double>::infinity());
    }
  }

  int moves() const { return static_cast<int>(x_.size()) - 1; }
  Vector2d at(int i) const { return {x_[static_cast<std::size_t>(i)], y_}; }
  double height(int move) const { return height_[static_cast<std::size_t>(move)]; }
  bool isOpen(int move) const { return std::isfinite(height(move)); }
  /// Whether there is stock that the move takes: on the level, or where it climbs.
  bool isNeeded(int move) const
  {
    const LevelMap& map = level_.map();
    const CellGrid& grid = map.grid();
    const int last = grid.columnOf(at(move + 1).x());
    for (int row = grid.rowOf(y_ - grid.cell / 2);
         row <= grid.rowOf(y_ + grid.cell / 2);
         ++row)
      for (int column = grid.columnOf(at(move).x()); column <= last; ++column)
        if (map.has({column, row}) &&
            map.stockTop({column, row}) > height(move) + 1e-3 &&
            (level_.isNeeded({column, row}) || height(move) > level_.z()))
          return true;
    return false;
  }

  /// The moves [first, last], forth or back. The tool goes up on the spot and comes
  /// down slanting, over a cell that is proven for the height below, so that it is
  /// never sunk straight.
  LevelPath path(int first, int last, bool back) const
  {
    LevelPath path;
    double z = height(back ? last : first);
    const auto add = [&](const Vector2d& xy, double to) {
      path.points.push_back({Vector3d(xy.x(), xy.y(), to)});
      path.reversible = path.reversible && to == path.points.front().at.z();
      z = to;
    };
    for (int k = 0; k <= last - first; ++k) {
      const int move = back ? last - k : first + k;
      if (k == 0 || height(move) > z)
        add(at(back ? move + 1 : move), height(move));
      add(at(back ? move : move + 1), height(move));
    }
    return path;
  }

private:
  const Level& level_;
  double y_;
  std::vector<double> x_;
  std::vector<double> height_; // of each move
};

/// Goes on from the end of `path` with `next` where the move aside is proven no higher
/// than either end of it.
bool goOn(const Level& level, LevelPath& path, const LevelPath& next, double most)
{
  const Vector3d a = path.points.back().at, b = next.points.front().at;
  const Vector2d from = a.head<2>(), to = b.head<2>();
  if ((to - from).norm() > most || std::abs(a.z() - b.z()) > 1e-9 ||
      level.map().lowestAlong(from, to) > a.z())
    return false;
  path.points.insert(path.points.end(), next.points.begin(), next.points.end());
  path.reversible = path.reversible && next.reversible;
  return true;
}

} // namespace

void GridRoughing::checkParameters() const
{
  LevelRoughing::checkParameters();
  if (!(cellSize() > 0.1 * getTool().endDiameter()))
    throw ParameterError(
        "GridRoughing: half the allowance is as wide as the tool's end");
}

std::vector<LevelPath> GridRoughing::clearLevel(const Level& level, Report&) const
{
  const double cell = cellSize(), aside = 0.5 * getAllowance();
  const double radius = level.map().endRadius();
  const double climb = stepDown();
  const Stock& stock = level.map().stock();
  std::vector<double> x = places(stock.min.x() - aside, cell, stock.max.x() - radius);
  x.insert(x.begin(), stock.min.x() - radius);
  x.push_back(stock.max.x() + radius);

  std::vector<LevelPath> paths;
  bool back = false;
  for (const double y :
       places(stock.min.y() + aside, cell, stock.max.y() - 0.9 * radius)) {
    const GridRow row(level, y, x, climb);
    std::vector<LevelPath> pieces;
    for (int i = 0; i < row.moves(); ++i) {
      const int begin = i;
      while (i < row.moves() && row.isOpen(i))
        ++i;
      neededStretches(
          begin,
          i,
          1,
          [&](int k) { return row.isNeeded(k); },
          [&](int first, int last) { pieces.push_back(row.path(first, last, back)); });
    }
    if (back)
      std::reverse(pieces.begin(), pieces.end());
    for (auto& piece : pieces)
      if (paths.empty() || !goOn(level, paths.back(), piece, 1.5 * cell))
        paths.push_back(std::move(piece));
    if (!pieces.empty())
      back = !back;
  }
  return paths;
}

std::vector<LevelPath> GridRoughing::clearRest(const Level& level,
                                               Material& material) const
{
  Material before = material;
  return shortRest(level, before, LevelRoughing::clearRest(level, material));
}

} // namespace pointmill
