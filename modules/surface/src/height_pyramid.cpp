// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "height_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
/// Any slope is valid; steeper ones would only magnify rounding.
constexpr double kSteepest = 8.0;
/// A hair more than half: rounding may put a point beside its cell.
constexpr double kHalf = 0.5001;

float roundUp(double v)
{
  const auto f = static_cast<float>(v);
  return f < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// Slopes of the plane that fits points best.
class PlaneFit {
public:
  void add(double x, double y, double z)
  {
    n_ += 1, x_ += x, y_ += y, z_ += z;
    xx_ += x * x, xy_ += x * y, yy_ += y * y, xz_ += x * z, yz_ += y * z;
  }
  void solve(double& sx, double& sy) const
  {
    sx = sy = 0;
    if (n_ < 3)
      return;
    const double xx = xx_ - x_ * x_ / n_, xy = xy_ - x_ * y_ / n_,
                 yy = yy_ - y_ * y_ / n_;
    const double xz = xz_ - x_ * z_ / n_, yz = yz_ - y_ * z_ / n_;
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-3 * xx * yy)) // nearly in one line
      return;
    sx = std::clamp((xz * yy - yz * xy) / det, -kSteepest, kSteepest);
    sy = std::clamp((yz * xx - xz * xy) / det, -kSteepest, kSteepest);
  }

private:
  double n_ = 0, x_ = 0, y_ = 0, z_ = 0, xx_ = 0, xy_ = 0, yy_ = 0, xz_ = 0, yz_ = 0;
};

} // namespace

HeightPyramid::HeightPyramid(const CellFrame& frame) : frame_(frame)
{
  int columns = frame.columns, rows = frame.rows;
  double size = frame.cell;
  // At least two: cells have the slopes of their parents.
  while (levels_.size() < 2 || columns > 1 || rows > 1) {
    Level level;
    level.size = size;
    level.blocks_x = (columns + kSide - 1) / kSide;
    level.blocks_y = (rows + kSide - 1) / kSide;
    const std::size_t n =
        static_cast<std::size_t>(level.blocks_x) * level.blocks_y * kNodes;
    level.top.resize(n);
    level.mid.resize(n);
    if (!levels_.empty()) {
      const auto nothing = static_cast<float>(kNothing);
      std::fill(level.top.begin(), level.top.end(), nothing);
      std::fill(level.mid.begin(), level.mid.end(), nothing);
      level.slope_x.assign(n, 0.f);
      level.slope_y.assign(n, 0.f);
    }
    columns = level.blocks_x;
    rows = level.blocks_y;
    size *= kSide;
    levels_.push_back(std::move(level));
  }
}

void HeightPyramid::addRows(const SortedPoints& points, int row0, int row1)
{
  for (int ty = row0 / kSide; ty * kSide < row1; ++ty)
    for (int tx = 0; tx < levels_[0].blocks_x; ++tx)
      addTile(points, tx, ty);
}

void HeightPyramid::addTile(const SortedPoints& points, int tx, int ty)
{
  const int c0 = tx * kSide, c1 = std::min(c0 + kSide, frame_.columns);
  const int r0 = ty * kSide, r1 = std::min(r0 + kSide, frame_.rows);
  const double x0 = frame_.x0 + (c0 + 0.5 * kSide) * frame_.cell;
  const double y0 = frame_.y0 + (r0 + 0.5 * kSide) * frame_.cell;
  const auto startOf = [&](int r, int c) {
    return points.start[static_cast<std::size_t>(r) * frame_.columns + c];
  };
  // One point of each cell shows how the ground slopes.
  PlaneFit fit;
  double z0 = 0;
  bool any = false;
  for (int r = r0; r < r1; ++r)
    for (int c = c0; c < c1; ++c)
      if (const auto i = startOf(r, c); i < startOf(r, c + 1)) {
        if (!any)
          z0 = points.z[i];
        any = true;
        fit.add(points.x[i] - x0, points.y[i] - y0, points.z[i] - z0);
      }
  double sx, sy;
  fit.solve(sx, sy);
  sx = static_cast<float>(sx);
  sy = static_cast<float>(sy);

  Level &cells = levels_[0], &tiles = levels_[1];
  const std::size_t block = cells.block(tx, ty), node = tiles.node(tx, ty);
  std::fill_n(&cells.top[block], kNodes, static_cast<float>(kNothing));
  std::fill_n(&cells.mid[block], kNodes, static_cast<float>(kNothing));
  float highest = static_cast<float>(kNothing);
  double lid = kNothing; // over the tile's middle
  for (int r = r0; r < r1; ++r)
    for (int c = c0; c < c1; ++c) {
      float top = static_cast<float>(kNothing);
      double mid = kNothing;
      for (std::size_t i = startOf(r, c), end = startOf(r, c + 1); i < end; ++i) {
        const double over =
            points.z[i] - sx * (points.x[i] - x0) - sy * (points.y[i] - y0);
        mid = over > mid ? over : mid;
        top = points.z[i] > top ? points.z[i] : top;
      }
      const std::size_t at = block + (r - r0) * kSide + (c - c0);
      const double dx = (c - c0 + 0.5 - 0.5 * kSide) * frame_.cell;
      const double dy = (r - r0 + 0.5 - 0.5 * kSide) * frame_.cell;
      cells.top[at] = top;
      cells.mid[at] = roundUp(mid + sx * dx + sy * dy);
      highest = std::max(highest, top);
      lid = std::max(lid, mid);
    }
  tiles.top[node] = highest;
  tiles.mid[node] = roundUp(lid);
  tiles.slope_x[node] = static_cast<float>(sx);
  tiles.slope_y[node] = static_cast<float>(sy);
}

void HeightPyramid::finish()
{
  for (std::size_t k = 1; k + 1 < levels_.size(); ++k)
    for (int j = 0; j < levels_[k].blocks_y; ++j)
      for (int i = 0; i < levels_[k].blocks_x; ++i)
        addParent(levels_[k], levels_[k + 1], i, j);
}

void HeightPyramid::addParent(const Level& children, Level& parents, int i, int j)
{
  const std::size_t block = children.block(i, j), node = parents.node(i, j);
  double sx = 0, sy = 0, count = 0;
  for (std::size_t k = block; k < block + kNodes; ++k)
    if (children.top[k] > kNothing) {
      sx += children.slope_x[k];
      sy += children.slope_y[k];
      count += 1;
    }
  if (count == 0)
    return;
  sx = static_cast<float>(sx / count);
  sy = static_cast<float>(sy / count);
  float top = static_cast<float>(kNothing);
  double mid = kNothing;
  for (int k = 0; k < kNodes; ++k) {
    const double dx = (k % kSide + 0.5 - 0.5 * kSide) * children.size;
    const double dy = (k / kSide + 0.5 - 0.5 * kSide) * children.size;
    const double more = kHalf * children.size *
                        (std::abs(children.slope_x[block + k] - sx) +
                         std::abs(children.slope_y[block + k] - sy));
    mid = std::max(mid, children.mid[block + k] + more - sx * dx - sy * dy);
    top = std::max(top, children.top[block + k]);
  }
  parents.top[node] = top;
  parents.mid[node] = roundUp(mid);
  parents.slope_x[node] = static_cast<float>(sx);
  parents.slope_y[node] = static_cast<float>(sy);
}

} // namespace pointmill
