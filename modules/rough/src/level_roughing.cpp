// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "border.h"

#include <pointmill/slice/z_slices.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pointmill {
namespace {

/// The corners of a chain: nodes in the middle of a straight run say nothing.
Chain corners(const Chain& chain)
{
  Chain kept;
  for (const Node n : chain) {
    if (kept.size() >= 2) {
      const Node a = kept[kept.size() - 2], b = kept.back();
      const int ux = b.column - a.column, uy = b.row - a.row;
      const int vx = n.column - b.column, vy = n.row - b.row;
      if (ux * vy == uy * vx && ux * vx + uy * vy > 0) {
        kept.back() = n;
        continue;
      }
    }
    if (kept.empty() || kept.back() != n)
      kept.push_back(n);
  }
  return kept;
}

/// Calls move(a, b) for every straight move of a chain with its tip on z.
template <typename Move>
void forMoves(const LevelMap& map, const Chain& chain, double z, Move&& move)
{
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Node a = chain[i > 0 ? i - 1 : 0], b = chain[i];
    move(Eigen::Vector3d(map.x(a), map.y(a), z),
         Eigen::Vector3d(map.x(b), map.y(b), z));
  }
}

/// The parts of the loop that still have stock above them after `work` was cut. Pieces
/// less than `gap` nodes apart stay together.
std::vector<Chain> piecesToCut(
    const LevelMap& map, const StockField& work, const Chain& loop, double z, int gap)
{
  // highest() looks half a diagonal further; cut() cuts what is half a diagonal inside.
  const double certain =
      std::max(0.0, map.endRadius() - std::sqrt(2.0) * work.cellSize());
  std::vector<Chain> pieces;
  int idle = gap + 1;
  for (const Node n : loop) {
    const bool needed =
        map.isNeeded(n, z) && work.highest(map.x(n), map.y(n), certain) > z + 1e-3;
    idle = needed ? 0 : idle + 1;
    if (needed && (pieces.empty() || pieces.back().empty()))
      pieces.emplace_back();
    if (idle <= gap)
      pieces.back().push_back(n);
    else if (!pieces.empty() && !pieces.back().empty())
      pieces.emplace_back();
  }
  pieces.erase(std::remove_if(pieces.begin(),
                              pieces.end(),
                              [](const Chain& c) { return c.size() < 2; }),
               pieces.end());
  return pieces;
}

/// One pass as it was planned: its corners and its level.
struct Pass {
  Chain chain;
  std::size_t level;
};

/// Calls visit(node) for every node on a chain of corners.
template <typename Visit>
void forNodes(const Chain& corners, Visit&& visit)
{
  const auto sign = [](int v) { return (v > 0) - (v < 0); };
  Node at = corners.front();
  visit(at);
  for (const Node to : corners)
    while (at != to) {
      at = at + Node{sign(to.column - at.column), sign(to.row - at.row)};
      visit(at);
    }
}

int stepsBetween(Node a, Node b)
{
  return std::abs(a.column - b.column) + std::abs(a.row - b.row);
}

/// The order in which regions that have no stock in common are each finished from top
/// to bottom, so that the tool stays where it is.
std::vector<std::size_t>
byRegion(const LevelMap& map, double floor, const std::vector<Pass>& passes)
{
  const auto regions = map.regions(floor);
  const auto regionAt = [&](Node n) {
    return regions[map.grid().index(n.column, n.row)];
  };
  // A pass that crosses from one region into another makes them one.
  std::vector<int> joined(*std::max_element(regions.begin(), regions.end()) + 1);
  std::iota(joined.begin(), joined.end(), 0);
  const auto find = [&](int r) {
    while (joined[r] != r)
      r = joined[r] = joined[joined[r]];
    return r;
  };
  for (const auto& pass : passes)
    forNodes(pass.chain, [&](Node n) {
      const int a = find(regionAt(pass.chain.front())), b = find(regionAt(n));
      joined[std::max(a, b)] = std::min(a, b);
    });
  const auto region = [&](std::size_t i) {
    return find(regionAt(passes[i].chain.front()));
  };
  std::vector<std::size_t> order(passes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return region(a) < region(b);
  });
  return order;
}

} // namespace

int LevelRoughing::stride(const LevelMap& map) const
{
  return std::max(1, static_cast<int>(std::floor(step_over_ / map.grid().cell + 1e-6)));
}

void LevelRoughing::checkParameters() const
{
  validateParameters(*this, getName());
  tool_.validate();
  if (step_over_ > tool_.endDiameter())
    throw ParameterError(getName() + ": the step-over is wider than the tool's end");
}

void LevelRoughing::apply(CLCloud& output)
{
  if (indices_->size() != input_->size())
    throw DataError(getName() + ": a map is roughed as a whole; it takes no indices");
  const CellGrid cells = CellGrid::of(*input_);
  double top = -std::numeric_limits<double>::infinity(), bottom = -top;
  for (const auto& cell : *input_)
    if (cell.getState() != CellState::Empty) {
      top = std::max<double>(top, cell.z);
      bottom = std::min<double>(bottom, cell.z);
    }
  if (!(top >= bottom))
    throw DataError(getName() + ": the map holds no part");
  auto stock = stock_;
  if (!stock)
    stock = std::make_shared<StockField>(Stock{{cells.x0, cells.y0, bottom - 1.0},
                                               {cells.x0 + cells.columns * cells.cell,
                                                cells.y0 + cells.rows * cells.cell,
                                                top}},
                                         cells.cell,
                                         StockField::Bound::Upper);

  const double floor = std::isnan(floor_) ? bottom : floor_;
  const double depth = stock->stock().top() - floor;
  if (depth >= 0 && depth < 1e-3) { // a flat plate: there is nothing to rough
    report_.set("levels", 0);
    return;
  }
  ZSlices slices;
  slices.setZLimits(floor, stock->stock().top());
  slices.setPitch(step_down_ > 0 ? step_down_
                                 : ZSlices::pitchForDiameter(tool_.endDiameter()));
  const auto levels = slices.levels();
  const LevelMap map(*input_,
                     part_.get(),
                     tool_,
                     allowance_,
                     *stock,
                     min_thickness_,
                     min_width_,
                     threads_);

  StockField work = *stock;
  std::vector<Pass> passes;
  std::size_t used = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double z = levels[k];
    const std::size_t before = passes.size();
    const auto take = [&](const Chain& chain) {
      passes.push_back({corners(chain), k});
      forMoves(map, passes.back().chain, z, [&](const auto& a, const auto& b) {
        work.cut(tool_, a, b);
      });
    };
    for (const auto& chain : clearLevel(map, z))
      take(chain);
    for (const auto& loop : borderLoops(map, z))
      for (const auto& piece : piecesToCut(map, work, loop, z, stride(map)))
        take(piece);
    used += passes.size() > before;
  }

  std::uint32_t label = 0;
  Node at;
  for (const std::size_t i : byRegion(map, levels.back(), passes)) {
    Pass& pass = passes[i];
    if (label > 0 &&
        stepsBetween(at, pass.chain.back()) < stepsBetween(at, pass.chain.front()))
      std::reverse(pass.chain.begin(), pass.chain.end());
    at = pass.chain.back();
    for (const Node n : pass.chain) {
      PointCL p(map.x(n), map.y(n), levels[pass.level]);
      p.label = label;
      p.level = static_cast<std::uint32_t>(pass.level);
      output.push_back(p);
    }
    ++label;
  }
  report_.set("levels", static_cast<double>(levels.size()));
  report_.set("levels_cut", static_cast<double>(used));
  report_.set("passes", label);
  report_.set("cl_points", static_cast<double>(output.size()));
}

} // namespace pointmill
