// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "candidates.h"
#include "moves.h"
#include "stretches.h"
#include "tiles.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Tiles of this part of the thinnest tool's radius: their bounds are tight, and they
/// still hold points enough to be worth a bound for each move.
constexpr double kTilesPerRadius = 3, kPointsPerTile = 16;
/// Stretches are dealt to blocks of as many tiles each way.
constexpr int kBlock = 2;

/// The deepest that a point gets inside a tool; of equals the first in the program.
struct Deepest {
  double depth = 0;
  std::size_t move = 0, point = 0;

  void take(const Deepest& other)
  {
    const auto place = [](const Deepest& d) { return std::make_pair(d.move, d.point); };
    if (other.depth > depth || (other.depth == depth && place(other) < place(*this)))
      *this = other;
  }
};

/// Sweeps moves over tiles, for one thread.
class TileSweep {
public:
  TileSweep(const Stretches& stretches, double tolerance)
      : stretches_(stretches), tolerance_(tolerance)
  {
  }

  /// Sweeps the stretches `near` over the tile, not in their order: first those that
  /// come lowest, so that most others need not be looked at.
  void sweep(const Tile& tile, const std::vector<std::uint32_t>& near)
  {
    height_.assign(tile.points.size(), std::numeric_limits<float>::infinity());
    gouged_.assign(tile.points.size(), 0);
    double limit = kInfinity;
    candidates_.clear();
    for (const auto i : near) {
      const HeightRange h = stretches_.range(i, tile.x, tile.y, tile.radius);
      if (h.low == kInfinity)
        continue;
      candidates_.add(h.low, kStretch | i);
      limit = std::min(limit, h.high);
    }
    candidates_.order(std::max(limit, tile.top - shallow()));
    double roof = kInfinity; // no point's height is above it
    while (!candidates_.empty() && (candidates_.best().bound < roof ||
                                    tile.top - candidates_.best().bound >= shallow())) {
      const auto [bound, id] = candidates_.take();
      if (id & kStretch) {
        expand(tile, id & ~kStretch);
        continue;
      }
      bool met = false;
      for (std::size_t i = 0; i < tile.points.size(); ++i) {
        const auto& p = tile.points[i];
        if (matters(bound, i, p) && matters(stretches_.floor(id, p.x, p.y), i, p)) {
          meet(p, i, id);
          met = true;
        }
      }
      if (met)
        roof = *std::max_element(height_.begin(), height_.end());
    }
    count_ += static_cast<std::size_t>(std::count(gouged_.begin(), gouged_.end(), 1));
  }

  /// Of the tile that was swept last.
  const std::vector<float>& heights() const { return height_; }
  /// Of all tiles.
  const Deepest& deepest() const { return deepest_; }
  std::size_t gouged() const { return count_; }

private:
  /// Marks the candidates that are stretches, the others are moves.
  static constexpr std::uint32_t kStretch = 1u << 31;

  /// Puts the moves of a stretch among the candidates.
  void expand(const Tile& tile, std::uint32_t i)
  {
    const MoveStretch& s = stretches_[i];
    for (std::uint32_t k = s.first; k < s.last; ++k) {
      const HeightRange h = stretches_.moveRange(k, tile.x, tile.y, tile.radius);
      if (h.low != kInfinity)
        candidates_.push(h.low, k);
    }
  }

  /// Points less deep inside a tool than this change nothing.
  double shallow() const { return std::min(tolerance_, deepest_.depth); }

  /// Whether a tool that comes as low as `h` over a point changes anything.
  bool matters(double h, std::size_t i, const Tile::Point& p) const
  {
    return h < height_[i] || p.z - h >= shallow();
  }

  void meet(const Tile::Point& p, std::size_t i, std::size_t k)
  {
    const SweptMove& m = stretches_.move(k);
    const CutterProfile& cutter = stretches_.cutter(k).profile();
    const double h = sweptHeight(cutter, m.a, m.b, p.x, p.y);
    if (h < height_[i])
      height_[i] = static_cast<float>(h);
    const double below = p.z - h; // at most as deep inside as below
    if (below > 0 && (below >= deepest_.depth || (below > tolerance_ && !gouged_[i]))) {
      const double depth = penetration(cutter, m.a, m.b, {p.x, p.y, p.z});
      gouged_[i] |= depth > tolerance_;
      if (depth > 0)
        deepest_.take({depth, k, p.index});
    }
  }

  const Stretches& stretches_;
  double tolerance_;
  Candidates candidates_;
  std::vector<float> height_;
  std::vector<unsigned char> gouged_;
  Deepest deepest_;
  std::size_t count_ = 0;
};

/// Where in X the tool can touch places with y0 <= y <= y1 on a stretch.
std::pair<double, double> extentIn(const MoveStretch& s, double y0, double y1)
{
  const double r = s.cutter->radius() + s.aside, dy = s.b.y() - s.a.y();
  double first = 0, last = 1;
  if (std::abs(dy) > 1e-12) {
    const double t0 = (y0 - r - s.a.y()) / dy, t1 = (y1 + r - s.a.y()) / dy;
    first = std::clamp(std::min(t0, t1), 0.0, 1.0);
    last = std::clamp(std::max(t0, t1), 0.0, 1.0);
  }
  const double dx = s.b.x() - s.a.x(), xa = s.a.x() + first * dx,
               xb = s.a.x() + last * dx;
  return {std::min(xa, xb) - r, std::max(xa, xb) + r};
}

} // namespace

Gouges sweepPoints(const PointIndex& part,
                   const std::vector<SweptMove>& moves,
                   double tolerance,
                   unsigned threads,
                   std::vector<float>& height)
{
  height.assign(part.size(), std::numeric_limits<float>::infinity());
  if (moves.empty())
    return {};
  const Stretches stretches(moves);
  const Tiles tiles(part, stretches.thinnest() / kTilesPerRadius, kPointsPerTile);
  const double edge = kBlock * tiles.edge();
  const int columns = (tiles.columns() + kBlock - 1) / kBlock;
  Bands bands(part.min().y(), edge, (tiles.rows() + kBlock - 1) / kBlock);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    checkInterrupted();
    const MoveStretch& s = stretches[i];
    bands.add(i, s.a.y(), s.b.y(), s.cutter->radius() + s.aside);
  }
  struct Outcome {
    Deepest deepest;
    std::size_t gouged = 0;
  };
  std::vector<Outcome> outcomes(static_cast<std::size_t>(bands.count()));
  parallelFor(outcomes.size(), threads, {0.1, 1.0}, [&](std::size_t band) {
    const double y0 = part.min().y() + static_cast<double>(band) * edge;
    std::vector<std::vector<std::uint32_t>> near(static_cast<std::size_t>(columns));
    const auto columnOf = [&](double x) {
      return static_cast<int>(std::clamp(
          std::floor((x - part.min().x()) / edge), -1.0, static_cast<double>(columns)));
    };
    for (const auto k : bands[band]) {
      const double hair = 1e-3 * edge; // for points sorted in float32
      const auto [x0, x1] = extentIn(stretches[k], y0 - hair, y0 + edge + hair);
      const int last = std::min(columns - 1, columnOf(x1 + hair));
      for (int c = std::max(0, columnOf(x0 - hair)); c <= last; ++c)
        near[static_cast<std::size_t>(c)].push_back(k);
    }
    TileSweep sweep(stretches, tolerance);
    Tile tile;
    const int row0 = static_cast<int>(band) * kBlock;
    for (int row = row0; row < std::min(tiles.rows(), row0 + kBlock); ++row)
      for (int column = 0; column < tiles.columns(); ++column) {
        tiles.read(column, row, tile);
        if (tile.points.empty())
          continue;
        checkInterrupted();
        sweep.sweep(tile, near[static_cast<std::size_t>(column / kBlock)]);
        for (std::size_t i = 0; i < tile.points.size(); ++i)
          height[tile.points[i].index] = sweep.heights()[i];
      }
    outcomes[band] = {sweep.deepest(), sweep.gouged()};
  });
  Deepest deepest;
  Gouges gouges;
  for (const auto& o : outcomes) {
    deepest.take(o.deepest);
    gouges.count += o.gouged;
  }
  if (deepest.depth > 0)
    gouges = {deepest.depth,
              part.point(deepest.point),
              moves[deepest.move].line,
              moves[deepest.move].tool->number,
              gouges.count};
  return gouges;
}

} // namespace pointmill
