// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "perfect_pass.h"

#include "candidates.h"
#include "tiles.h"

#include <pointmill/common/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNodesPerRadius = 8, kTilesPerRadius = 4, kPointsPerTile = 48;
constexpr double kSettled = 0.001; ///< search no better than this [mm]

/// Where the tool stands lowest over a point, as far as it was searched.
struct Best {
  double height = kInfinity;
  double x = 0, y = 0; ///< of the tip
};

} // namespace

/// Where the tool rests over the nodes of a fine grid that covers all places from which
/// it touches the part.
class PerfectPass::RestGrid {
public:
  RestGrid(const PerfectPass& pass, const PointIndex& part, const Tool& tool)
      : cell_(tool.radius() / kNodesPerRadius), x0_(part.min().x() - tool.radius()),
        y0_(part.min().y() - tool.radius())
  {
    const Eigen::Vector3d size = part.max() - part.min();
    columns_ = static_cast<int>((size.x() + 2 * tool.radius()) / cell_) + 2;
    rows_ = static_cast<int>((size.y() + 2 * tool.radius()) / cell_) + 2;
    tip_.resize(static_cast<std::size_t>(columns_) * rows_);
    contact_.resize(tip_.size());
    const CutterProfile cutter = tool.profile();
    const auto count = static_cast<std::size_t>(rows_);
    parallelFor(count, pass.threads_, {0.0, 0.3}, [&](std::size_t row) {
      std::vector<Contact> contacts(static_cast<std::size_t>(columns_));
      part.dropRow(tool,
                   {x0_, y(static_cast<int>(row))},
                   {cell_, 0},
                   contacts.size(),
                   contacts.data());
      for (std::size_t c = 0; c < contacts.size(); ++c) {
        const double lowest =
            pass.lowest(cutter, x(static_cast<int>(c)), y(static_cast<int>(row)));
        tip_[row * columns_ + c] =
            static_cast<float>(std::max(lowest, contacts[c].tip));
        contact_[row * columns_ + c] = static_cast<std::uint32_t>(contacts[c].point);
      }
    });
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cell() const { return cell_; }
  double x(int column) const { return x0_ + column * cell_; }
  double y(int row) const { return y0_ + row * cell_; }
  int columnOf(double v) const { return clamped((v - x0_) / cell_, columns_); }
  int rowOf(double v) const { return clamped((v - y0_) / cell_, rows_); }
  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * columns_ + column;
  }
  double tip(std::size_t node) const { return tip_[node]; }
  /// The point that the tool rests on; where there is none, more than the points are.
  std::uint32_t contact(std::size_t node) const { return contact_[node]; }

private:
  static int clamped(double v, int count)
  {
    return static_cast<int>(std::clamp(v, 0.0, count - 1.0));
  }
  double cell_, x0_, y0_;
  int columns_ = 0, rows_ = 0;
  std::vector<float> tip_;
  std::vector<std::uint32_t> contact_;
};

/// The best nodes for the points of a tile.
class PerfectPass::TileSearch {
public:
  TileSearch(const RestGrid& grid, const Tool& tool)
      : grid_(grid), tool_(tool), cutter_(tool.profile())
  {
  }

  void search(const Tile& tile)
  {
    gather(tile);
    best_.assign(tile.points.size(), Best());
    double roof = kInfinity; // nothing is open above it
    while (!candidates_.empty() && candidates_.best().bound < roof) {
      const auto [bound, node] = candidates_.take();
      const double tip = grid_.tip(node);
      const double x = grid_.x(static_cast<int>(node % grid_.columns()));
      const double y = grid_.y(static_cast<int>(node / grid_.columns()));
      roof = -kInfinity;
      for (std::size_t i = 0; i < best_.size(); ++i) {
        const auto& p = tile.points[i];
        Best& best = best_[i];
        if (bound < best.height) {
          const double dx = x - p.x, dy = y - p.y;
          const double h = tip + cutter_.height(std::sqrt(dx * dx + dy * dy));
          if (h < best.height)
            best = {h, x, y};
        }
        if (best.height > p.z) // nothing goes lower than the point itself
          roof = std::max(roof, best.height);
      }
    }
  }
  const std::vector<Best>& best() const { return best_; }

private:
  void gather(const Tile& tile)
  {
    candidates_.clear();
    const double r = tool_.radius(), reach = r + tile.radius;
    const int c0 = grid_.columnOf(tile.x - reach), c1 = grid_.columnOf(tile.x + reach);
    const int r0 = grid_.rowOf(tile.y - reach), r1 = grid_.rowOf(tile.y + reach);
    double roof = kInfinity; // the tool at one node is over no point higher than that
    for (int row = r0; row <= r1; ++row)
      for (int column = c0; column <= c1; ++column) {
        const double dx = grid_.x(column) - tile.x, dy = grid_.y(row) - tile.y;
        const double away = std::sqrt(dx * dx + dy * dy) - tile.radius - 1e-9;
        if (away > r)
          continue;
        const std::size_t node = grid_.index(column, row);
        const double tip = grid_.tip(node);
        candidates_.add(tip + cutter_.height(std::max(0.0, away)) - 1e-9, node);
        roof = std::min(roof, tip + cutter_.height(away + 2 * tile.radius + 2e-9));
      }
    candidates_.order(roof);
  }

  const RestGrid& grid_;
  const Tool& tool_;
  const CutterProfile cutter_;
  Candidates candidates_;
  std::vector<Best> best_;
};

/// Searches on around the best node, which is too coarse on steep and rough ground. The
/// few points that the tool rests on thereabouts stand for the whole part; where it is
/// dropped on all of it and rests on another point, that one joins them.
class PerfectPass::Refinement {
public:
  Refinement(const PerfectPass& pass, double close)
      : pass_(pass), part_(pass.part_), grid_(*pass.grid_), tool_(pass.tool_),
        cutter_(tool_.profile()), close_(close)
  {
  }

  double refine(const Tile::Point& p, const Best& start)
  {
    Best best = start;
    gather(start);
    for (int round = 0; round < kRounds && best.height - p.z > close_; ++round) {
      const Best guess = lowestOnRests(p, best);
      if (guess.height > best.height - kSettled)
        break;
      const Contact contact = part_.drop(tool_, guess.x, guess.y);
      const double d = std::hypot(guess.x - p.x, guess.y - p.y);
      const double h = std::max(pass_.lowest(cutter_, guess.x, guess.y), contact.tip) +
                       cutter_.height(d);
      if (h < best.height)
        best = {h, guess.x, guess.y};
      if (h < guess.height + kSettled)
        break;
      rests_.push_back(contact.at);
    }
    return best.height;
  }

private:
  static constexpr int kRounds = 8, kHalvings = 4;

  void gather(const Best& start)
  {
    rests_.clear();
    seen_.clear();
    const int c = grid_.columnOf(start.x + grid_.cell() / 2);
    const int r = grid_.rowOf(start.y + grid_.cell() / 2);
    for (int row = std::max(0, r - 1); row <= std::min(grid_.rows() - 1, r + 1); ++row)
      for (int column = std::max(0, c - 1);
           column <= std::min(grid_.columns() - 1, c + 1);
           ++column) {
        const std::uint32_t point = grid_.contact(grid_.index(column, row));
        if (point < part_.size() &&
            std::find(seen_.begin(), seen_.end(), point) == seen_.end()) {
          seen_.push_back(point);
          rests_.push_back(part_.point(point));
        }
      }
  }

  /// Height over p of the tool at (x, y) if there were only the rests.
  double heightOnRests(const Tile::Point& p, double x, double y) const
  {
    const double d2 = (x - p.x) * (x - p.x) + (y - p.y) * (y - p.y);
    if (d2 > tool_.radius() * tool_.radius())
      return kInfinity;
    double tip = pass_.lowest(cutter_, x, y);
    for (const auto& q : rests_) {
      const double q2 = (x - q.x()) * (x - q.x()) + (y - q.y()) * (y - q.y());
      if (q2 <= tool_.radius() * tool_.radius())
        tip = std::max(tip, q.z() - cutter_.height(std::sqrt(q2)));
    }
    return tip + cutter_.height(std::sqrt(d2));
  }

  /// From `from` in ever smaller steps, not farther than a cell: there are other rests.
  Best lowestOnRests(const Tile::Point& p, const Best& from) const
  {
    Best best{heightOnRests(p, from.x, from.y), from.x, from.y};
    double step = grid_.cell() / 2;
    for (int halving = 0; halving < kHalvings;) {
      const Best centre = best;
      for (int k = 0; k < 9; ++k) {
        const double x = centre.x + (k % 3 - 1) * step,
                     y = centre.y + (k / 3 - 1) * step;
        if (k == 4 || std::abs(x - from.x) > grid_.cell() ||
            std::abs(y - from.y) > grid_.cell())
          continue;
        const double h = heightOnRests(p, x, y);
        if (h < best.height)
          best = {h, x, y};
      }
      if (best.height > centre.height - kSettled) {
        step /= 2;
        ++halving;
      }
    }
    return best;
  }

  const PerfectPass& pass_;
  const PointIndex& part_;
  const RestGrid& grid_;
  const Tool& tool_;
  const CutterProfile cutter_;
  double close_;
  std::vector<Eigen::Vector3d> rests_;
  std::vector<std::uint32_t> seen_;
};

PerfectPass::PerfectPass(const PointIndex& part,
                         const Tool& tool,
                         double floor,
                         unsigned threads,
                         KeepOut keep_out)
    : part_(part), tool_(tool), floor_(floor), keep_out_(std::move(keep_out)),
      threads_(threads), grid_(std::make_unique<RestGrid>(*this, part, tool))
{
}

PerfectPass::~PerfectPass() = default;

std::vector<float> PerfectPass::heightsOver(const PointIndex& points,
                                            double close) const
{
  std::vector<float> heights(points.size());
  const Tiles tiles(points, tool_.radius() / kTilesPerRadius, kPointsPerTile);
  const auto rows = static_cast<std::size_t>(tiles.rows());
  parallelFor(rows, threads_, {0.3, 1.0}, [&](std::size_t row) {
    TileSearch search(*grid_, tool_);
    Refinement refinement(*this, close);
    Tile tile;
    for (int column = 0; column < tiles.columns(); ++column) {
      tiles.read(column, static_cast<int>(row), tile);
      if (tile.points.empty())
        continue;
      checkInterrupted();
      search.search(tile);
      for (std::size_t i = 0; i < tile.points.size(); ++i) {
        const auto& p = tile.points[i];
        const Best& best = search.best()[i];
        const double over = best.height - p.z; // by far: something covers the point
        heights[p.index] = static_cast<float>(over > close && over < tool_.radius()
                                                  ? refinement.refine(p, best)
                                                  : best.height);
      }
    }
  });
  return heights;
}

} // namespace pointmill
