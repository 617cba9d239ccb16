// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// A point this far under a perfect pass of the last tool is out of its reach [mm]:
/// more than what noise lifts the tool off.
constexpr double kReach = 0.1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Quantiles quantiles(std::vector<float>& values)
{
  Quantiles q;
  if (values.empty())
    return q;
  const auto at = [&](double share) {
    const auto k = std::min(values.size() - 1,
                            static_cast<std::size_t>(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(k), values.end());
    return double(values[k]);
  };
  q.p50 = at(0.50);
  q.p95 = at(0.95);
  q.p99 = at(0.99);
  q.max = *std::max_element(values.begin(), values.end());
  return q;
}

/// What a perfect pass of a tool leaves: the tip's lowest height on a fine grid, and
/// from that the lowest surface over a place.
class Envelope {
public:
  Envelope(const PointIndex& part, const Tool& tool, double floor, unsigned threads)
      : part_(part), tool_(tool), cutter_(tool.profile()), floor_(floor),
        cell_(tool.radius() / 8), x0_(part.min().x() - tool.radius()),
        y0_(part.min().y() - tool.radius())
  {
    const Eigen::Vector3d size = part.max() - part.min();
    columns_ = static_cast<int>((size.x() + 2 * tool.radius()) / cell_) + 2;
    rows_ = static_cast<int>((size.y() + 2 * tool.radius()) / cell_) + 2;
    tip_.resize(static_cast<std::size_t>(columns_) * rows_);
    parallelFor(static_cast<std::size_t>(rows_), threads, [&](std::size_t row) {
      for (int c = 0; c < columns_; ++c)
        tip_[row * columns_ + c] = static_cast<float>(
            std::max(floor_, part.drop(tool_, x0_ + c * cell_, y0_ + row * cell_).tip));
    });
    const int n = static_cast<int>(std::ceil(tool.radius() / cell_)) + 1;
    reach_ = n;
  }

  double lowestOver(const Eigen::Vector3d& p) const
  {
    const int ci = static_cast<int>((p.x() - x0_) / cell_ + 0.5);
    const int cj = static_cast<int>((p.y() - y0_) / cell_ + 0.5);
    double best = kInfinity, bx = p.x(), by = p.y();
    for (int j = std::max(0, cj - reach_); j <= std::min(rows_ - 1, cj + reach_); ++j)
      for (int i = std::max(0, ci - reach_); i <= std::min(columns_ - 1, ci + reach_);
           ++i) {
        const double tip = tip_[static_cast<std::size_t>(j) * columns_ + i];
        if (tip >= best)
          continue;
        const double x = x0_ + i * cell_, y = y0_ + j * cell_;
        const double h = tip + cutter_.height(std::hypot(x - p.x(), y - p.y()));
        if (h < best) {
          best = h;
          bx = x;
          by = y;
        }
      }
    // On steep ground the grid is too coarse: search on around its best place.
    double step = cell_ / 2;
    const bool near = best - p.z() < tool_.radius(); // else something covers it
    for (int round = 0; near && round < kRefinements && best - p.z() > kClose;
         ++round) {
      const double x = bx, y = by;
      for (int k = 0; k < 9; ++k) {
        const double tx = x + (k % 3 - 1) * step, ty = y + (k / 3 - 1) * step;
        const double d = std::hypot(tx - p.x(), ty - p.y());
        if (d > tool_.radius())
          continue;
        const double tip = std::max(floor_, part_.drop(tool_, tx, ty).tip);
        const double h = tip + cutter_.height(d);
        if (h < best) {
          best = h;
          bx = tx;
          by = ty;
        }
      }
      if (bx == x && by == y)
        step /= 2;
    }
    return best;
  }

private:
  static constexpr int kRefinements = 4;
  static constexpr double kClose = 0.01; ///< near enough to the point itself [mm]

  const PointIndex& part_;
  Tool tool_;
  CutterProfile cutter_;
  double floor_, cell_, x0_, y0_;
  int columns_ = 0, rows_ = 0, reach_ = 0;
  std::vector<float> tip_;
};

} // namespace

Gouges sweepPoints(const PointIndex& part,
                   const std::vector<SweptMove>& moves,
                   double tolerance,
                   unsigned threads,
                   std::vector<float>& height)
{
  const Bands bands(moves, part.min().y(), part.cellSize(), part.rows());
  height.assign(part.size(), std::numeric_limits<float>::infinity());
  struct Worst {
    double depth = 0;
    std::size_t point = 0, line = 0, count = 0;
  };
  std::vector<Worst> worst(static_cast<std::size_t>(bands.count()));
  parallelFor(worst.size(), threads, [&](std::size_t band) {
    const int row = static_cast<int>(band);
    std::vector<std::size_t> gouged;
    for (const auto k : bands[band]) {
      const SweptMove& m = moves[k];
      const CutterProfile cutter = m.tool->profile();
      const double r = cutter.radius(), lowest = std::min(m.a.z(), m.b.z());
      const double x0 = std::min(m.a.x(), m.b.x()) - r,
                   x1 = std::max(m.a.x(), m.b.x()) + r;
      if (x1 < part.min().x() || x0 > part.max().x())
        continue;
      const auto [first, last] = part.cells(row, part.columnOf(x0), part.columnOf(x1));
      for (std::size_t q = first; q < last; ++q) {
        if (lowest >= height[q] && lowest + tolerance >= part.point(q).z())
          continue;
        const Eigen::Vector3d p = part.point(q);
        const double h = sweptHeight(cutter, m.a, m.b, p.x(), p.y());
        if (h < height[q])
          height[q] = static_cast<float>(h);
        if (p.z() - h > tolerance) { // at most as deep inside as below
          const double depth = penetration(cutter, m.a, m.b, p);
          if (depth > tolerance)
            gouged.push_back(q);
          if (depth > worst[band].depth)
            worst[band] = {depth, q, m.line, 0};
        }
        else if (p.z() - h > worst[band].depth) {
          const double depth = penetration(cutter, m.a, m.b, p);
          if (depth > worst[band].depth)
            worst[band] = {depth, q, m.line, 0};
        }
      }
    }
    std::sort(gouged.begin(), gouged.end());
    worst[band].count = static_cast<std::size_t>(
        std::unique(gouged.begin(), gouged.end()) - gouged.begin());
  });
  Gouges gouges;
  for (const auto& w : worst) {
    gouges.count += w.count;
    if (w.depth > gouges.depth) {
      gouges.depth = w.depth;
      gouges.at = part.point(w.point);
      gouges.line = w.line;
    }
  }
  return gouges;
}

void judgePoints(const PointIndex& part,
                 const std::vector<SweptMove>& moves,
                 double tolerance,
                 double floor,
                 unsigned threads,
                 Verification& result)
{
  std::vector<float> height;
  const Gouges gouges = sweepPoints(part, moves, tolerance, threads, height);
  result.gouge = gouges.depth;
  result.gouge_at = gouges.at;
  result.gouge_line = gouges.line;
  result.gouged_points = gouges.count;
  result.points = part.size();

  const Tool* last = nullptr;
  for (const auto& m : moves)
    if (!m.rapid)
      last = m.tool;
  if (!last)
    return;
  const Envelope envelope(part, *last, std::max(part.min().z(), floor), threads);
  std::vector<float> residual(part.size()), deviation(part.size());
  std::vector<unsigned char> reachable(part.size());
  parallelFor(static_cast<std::size_t>(part.rows()), threads, [&](std::size_t row) {
    const auto [first, end] = part.cells(static_cast<int>(row), 0, part.columns() - 1);
    for (std::size_t q = first; q < end; ++q) {
      const Eigen::Vector3d p = part.point(q);
      const double perfect = std::max(p.z(), envelope.lowestOver(p));
      reachable[q] = perfect - p.z() <= kReach;
      residual[q] = std::max(0.f, static_cast<float>(height[q] - perfect));
      deviation[q] = static_cast<float>(height[q] - p.z());
    }
  });
  std::vector<float> left, off;
  for (std::size_t q = 0; q < part.size(); ++q) {
    result.unreachable_points += !reachable[q];
    const bool touched = std::isfinite(height[q]);
    result.untouched_points += !touched;
    left.push_back(residual[q]); // infinite where no tool comes by
    if (touched && reachable[q])
      off.push_back(deviation[q]);
  }
  result.points = part.size();
  result.residual = quantiles(left);
  result.deviation = quantiles(off);
}

} // namespace pointmill
