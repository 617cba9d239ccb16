// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Part of search.cpp: down the pyramid.

/// About where the cutter with its axis at @p axis touches the ground, from the axis:
/// the place where it slopes as the ground does, taken from where it was thought to be.
inline Eigen::Vector2d contactFrom(const HeightPyramid& pyramid,
                                   const CellFrame& frame,
                                   const CutterUnderside& underside,
                                   const Eigen::Vector2d& axis,
                                   const Eigen::Vector2d& offset)
{
  const auto& tiles = pyramid.level(1);
  const std::size_t tile =
      tiles.node(frame.column(axis.x() + offset.x()) / HeightPyramid::kSide,
                 frame.row(axis.y() + offset.y()) / HeightPyramid::kSide);
  const Eigen::Vector2d slope(tiles.slope_x[tile], tiles.slope_y[tile]);
  const double steep = slope.norm();
  if (!(steep > 0))
    return {0, 0};
  return slope * (underside.radiusAt(steep) / steep);
}

/// Goes down the pyramid, the most promising node of a block first, and gives the taker
/// the runs of points whose values can be taker.best() or more, which may rise by that.
/// Serves any number of equal moves, one after the other.
template <bool kMoves, typename Taker>
class Hunt {
public:
  Hunt(const SearchSpace& space, const Move& move, double radius)
      : points_(space.points), pyramid_(space.pyramid), frame_(space.points.frame),
        sieve_(move, radius)
  {
    low_x_ = std::min(0.0, move.dx) - radius, high_x_ = std::max(0.0, move.dx) + radius;
    low_y_ = std::min(0.0, move.dy) - radius, high_y_ = std::max(0.0, move.dy) + radius;
    // Blocks about as large as the cutter: a handful covers it.
    const double wanted =
        kBlock * std::max({radius, std::abs(move.dx), std::abs(move.dy)});
    while (top_level_ + 1 < pyramid_.levels() &&
           HeightPyramid::kSide * pyramid_.level(top_level_).size < wanted)
      ++top_level_;
    for (int k = 0; k <= top_level_ + 1 && k < pyramid_.levels(); ++k)
      reach2_[k] = sieve_.reach2(pyramid_.level(k).size);
    largest_ = pyramid_.level(top_level_).size;
    per_block_ = 1 / (HeightPyramid::kSide * largest_);
  }

  /// Goes to the move from (ax, ay). False where it meets nothing.
  bool startAt(double ax, double ay, Taker& taker)
  {
    taker_ = &taker;
    const double x0 = ax + low_x_, x1 = ax + high_x_;
    const double y0 = ay + low_y_, y1 = ay + high_y_;
    // written so that NaN meets nothing
    if (!(x1 >= points_.min.x() && y1 >= points_.min.y() && x0 <= points_.max.x() &&
          y0 <= points_.max.y()))
      return false;
    sieve_.startAt(ax, ay);
    const double hair = 1e-4 * largest_;
    const auto& level = pyramid_.level(top_level_);
    const auto block = [&](double at, int count) {
      return static_cast<int>(std::min(std::max(at * per_block_, 0.0), count - 1.0));
    };
    i0_ = block(x0 - hair - frame_.x0, level.blocks_x);
    i1_ = block(x1 + hair - frame_.x0, level.blocks_x);
    j0_ = block(y0 - hair - frame_.y0, level.blocks_y);
    j1_ = block(y1 + hair - frame_.y0, level.blocks_y);
    return true;
  }

  /// From another height, to one that is higher by dz.
  void tilt(double az, double dz) { sieve_.tilt(az, dz); }

  /// Asks a good point first, and returns a paraboloid that touches the cutter there.
  Paraboloid seed(const CutterUnderside& underside)
  {
    const Move& move = sieve_.move();
    const Eigen::Vector2d middle(move.ax + 0.5 * move.dx, move.ay + 0.5 * move.dy);
    Eigen::Vector2d offset(0, 0);
    for (int round = 0; round < 3; ++round)
      offset = contactFrom(pyramid_, frame_, underside, middle, offset);
    const Paraboloid under = underside.touching(offset.norm());
    sieve_.lean(under, highest(), largest_);
    sieve_.demand(-kInfinity);
    askHighest(middle + offset);
    if (!(taker_->best() > -kInfinity))
      descend();
    return under;
  }

  /// All points whose values can be taker.best() or more.
  void all(const Paraboloid& under)
  {
    const double best = taker_->best();
    sieve_.lean(under, best > -kInfinity ? best : highest(), largest_);
    sieve_.demand(best);
    for (int j = j0_; j <= j1_; ++j)
      for (int i = i0_; i <= i1_; ++i) {
        open(top_level_, i, j);
        while (depth_ > 0) {
          const Node node = stack_[--depth_];
          if (matters(node))
            open(node.level - 1, node.i, node.j);
        }
      }
  }

private:
  struct Node {
    float bound;
    int level, i, j; // level -1: none
  };

  void askHighest(const Eigen::Vector2d& at)
  {
    const std::size_t first =
        points_.start[static_cast<std::size_t>(frame_.row(at.y())) * frame_.columns +
                      frame_.column(at.x())];
    const int k =
        sieve_.highest(&points_.x[first], &points_.y[first], &points_.z[first]);
    if (k >= 0)
      taker_->ask(first + static_cast<std::size_t>(k));
  }

  /// Follows the most promising nodes only, down to one cell.
  void descend()
  {
    // From a level higher up: fewer blocks, and here no node needs to be excluded.
    const int up = top_level_ + 1 < pyramid_.levels() ? 2 : 0; // 4 x 4 as a shift
    int level = top_level_ + up / 2;
    Node best = none();
    for (int j = j0_ >> up; j <= j1_ >> up; ++j)
      for (int i = i0_ >> up; i <= i1_ >> up; ++i)
        best = better(best, bestOf(level, i, j));
    for (; level > 0 && best.level >= 0; --level) {
      sieve_.demand(-kInfinity);
      best = bestOf(level - 1, best.i, best.j);
    }
    if (best.level >= 0)
      askHighest({frame_.x0 + (best.i + 0.5) * frame_.cell,
                  frame_.y0 + (best.j + 0.5) * frame_.cell});
  }

  static constexpr double kBlock = 0.6;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr int kMostLevels = 16; // 4^16 cells in a row are more than an int

  static Node none() { return {-std::numeric_limits<float>::infinity(), -1, 0, 0}; }
  static const Node& better(const Node& a, const Node& b)
  {
    return b.bound > a.bound ? b : a;
  }

  double highest() const { return points_.max.z() - sieve_.move().az; }

  /// Bounds of the nodes of a block, and which of them matter.
  unsigned boundsOf(int level, int i, int j, float* bound) const
  {
    const auto& nodes = pyramid_.level(level);
    const std::size_t block = nodes.block(i, j);
    const double x =
        frame_.x0 + (HeightPyramid::kSide * i + 0.5) * nodes.size - sieve_.move().ax;
    const double y =
        frame_.y0 + (HeightPyramid::kSide * j + 0.5) * nodes.size - sieve_.move().ay;
    if (level > 0)
      return sieve_.template nodes<false>(
          nodes, block, x, y, 0.f, 0.f, reach2_[level], bound);
    const auto& tiles = pyramid_.level(1);
    const std::size_t tile = tiles.node(i, j);
    return sieve_.template nodes<true>(nodes,
                                       block,
                                       x,
                                       y,
                                       tiles.slope_x[tile],
                                       tiles.slope_y[tile],
                                       reach2_[0],
                                       bound);
  }

  static Node nodeOf(int level, int i, int j, int k, const float* bound)
  {
    return {bound[k],
            level,
            HeightPyramid::kSide * i + k % HeightPyramid::kSide,
            HeightPyramid::kSide * j + k / HeightPyramid::kSide};
  }

  /// The highest of a block, if it is higher than the last one.
  Node bestOf(int level, int i, int j)
  {
    alignas(64) float bound[HeightPyramid::kNodes];
    Node best = none();
    for (unsigned mask = boundsOf(level, i, j, bound); mask; mask &= mask - 1)
      best = better(best, nodeOf(level, i, j, __builtin_ctz(mask), bound));
    if (best.level >= 0)
      sieve_.demandOfNodes(best.bound);
    return best;
  }

  std::uint32_t firstPoint(const Node& node) const
  {
    const std::size_t column = static_cast<std::size_t>(node.i) << 2 * node.level,
                      row = static_cast<std::size_t>(node.j) << 2 * node.level;
    return points_.start[row * frame_.columns + column];
  }

  /// From the axis to anywhere in the node, or less.
  double distanceTo(const Node& node) const
  {
    const double size = pyramid_.level(node.level).size, half = 0.5001 * size;
    const Move& move = sieve_.move();
    const double x = frame_.x0 + (node.i + 0.5) * size - move.ax;
    const double y = frame_.y0 + (node.j + 0.5) * size - move.ay;
    if (kMoves)
      return std::max(0.0,
                      std::sqrt(segmentDistance2(0, 0, move.dx, move.dy, x, y)) -
                          1.4143 * half);
    const double u = std::max(0.0, std::abs(x) - half),
                 v = std::max(0.0, std::abs(y) - half);
    return std::sqrt(u * u + v * v);
  }

  bool matters(const Node& node) const
  {
    return sieve_.flat()
               ? taker_->mayBeat(node.bound, distanceTo(node), firstPoint(node))
               : node.bound >= sieve_.limit();
  }

  /// Puts the nodes of a block that matter on the stack, the best on top; the points of
  /// cells go to the taker.
  void open(int level, int i, int j)
  {
    alignas(64) float bound[HeightPyramid::kNodes];
    unsigned mask = boundsOf(level, i, j, bound);
    if (level == 0) {
      if (mask)
        takeCells(i, j, mask, bound);
      return;
    }
    int best = depth_;
    for (; mask; mask &= mask - 1) {
      stack_[depth_] = nodeOf(level, i, j, __builtin_ctz(mask), bound);
      if (stack_[depth_].bound > stack_[best].bound)
        best = depth_;
      ++depth_;
    }
    if (depth_ > 0 && best < depth_)
      std::swap(stack_[best], stack_[depth_ - 1]);
  }

  void takeCells(int i, int j, unsigned mask, const float* bound)
  {
    if (sieve_.flat())
      for (unsigned rest = mask; rest; rest &= rest - 1) {
        const int k = __builtin_ctz(rest);
        if (!matters(nodeOf(0, i, j, k, bound)))
          mask &= ~(1u << k);
      }
    for (int row = HeightPyramid::kSide * j; mask; ++row, mask >>= 4) {
      const unsigned cells = mask & 15u;
      if (!cells)
        continue;
      const std::uint32_t* start =
          &points_.start[static_cast<std::size_t>(row) * frame_.columns +
                         HeightPyramid::kSide * i];
      const std::size_t first = start[__builtin_ctz(cells)];
      taker_->take(sieve_, first, start[32 - __builtin_clz(cells)]);
    }
  }

  const SortedPoints& points_;
  const HeightPyramid& pyramid_;
  const CellFrame& frame_;
  Sieve<kMoves> sieve_;
  Taker* taker_ = nullptr;
  double low_x_, high_x_, low_y_, high_y_, largest_, per_block_;
  int top_level_ = 0, i0_ = 0, i1_ = 0, j0_ = 0, j1_ = 0;
  float reach2_[kMostLevels];
  int depth_ = 0;
  Node stack_[kMostLevels * HeightPyramid::kNodes];
};

/// Takes points by their exact values.
template <typename Value>
struct Exactly : Value {
  using Value::Value;
  template <typename Sieve>
  void take(Sieve& sieve, std::size_t first, std::size_t last)
  {
    const SortedPoints& p = this->points();
    sieve.sift(&p.x[first], &p.y[first], &p.z[first], last - first, *this, [&](auto k) {
      return first + k;
    });
  }
};
