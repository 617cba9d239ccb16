// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// The search, compiled once for each instruction set: search.cpp includes this file into
// a namespace of its own for each, with kLanes floats in a vector and bitsOf().

typedef float Floats __attribute__((vector_size(4 * kLanes)));
typedef int Bits __attribute__((vector_size(4 * kLanes)));

inline Floats load(const float* from)
{
  Floats v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

inline Floats magnitude(Floats v)
{
  return (Floats)((Bits)v & 0x7fffffff);
}

inline Floats clamped(Floats v) // to 0 .. 1
{
  const Floats zero{}, one = zero + 1.f;
  v = v > zero ? v : zero;
  return v < one ? v : one;
}

/// The straight move of a cutter's axis, or with kMoves false a place where it is
/// dropped. A point's value is how far it stands over the cutter's lower surface (over
/// its tip, for a drop), and the values of many points are bounded at once: with a
/// paraboloid under the cutter, which any slope of the ground is held against; or, where
/// the cutter's bottom is flat, by height alone, which is exact.
template <bool kMoves>
class Sieve {
public:
  Sieve(const Move& move, double radius) : move_(move), radius_(radius)
  {
    ax_ = static_cast<float>(move.ax);
    ay_ = static_cast<float>(move.ay);
    ax_rest_ = static_cast<float>(move.ax - ax_);
    ay_rest_ = static_cast<float>(move.ay - ay_);
    dx_ = static_cast<float>(move.dx);
    dy_ = static_cast<float>(move.dy);
    dz_ = static_cast<float>(move.dz);
    length_ = kMoves ? std::sqrt(move.dx * move.dx + move.dy * move.dy) : 0.0;
    per_length2_ = static_cast<float>(length_ > 0 ? 1 / (length_ * length_) : 0.0);
    reach2_ = reach2(0.0);
  }

  /// Goes over to another paraboloid; values are near @p base.
  void lean(const Paraboloid& under, double base, double largest_node)
  {
    flat_ = !(under.bend * radius_ * radius_ > 1e-6);
    if (flat_) {
      base_ = -(move_.az + std::min(0.0, move_.dz));
      reference_ = offset_ = 0;
      return;
    }
    base_ = base;
    bend_ = static_cast<float>(under.bend);
    reference_ = static_cast<float>(move_.az + base);
    offset_ = static_cast<float>(move_.az + base - reference_ + under.height);
    lag_ = kMoves && length_ > 0
               ? static_cast<float>(move_.dz / (2 * under.bend * length_ * length_))
               : 0.f;
    // What the terms of a bound can add up to where it is near zero; each of the few
    // operations rounds by 2^-24 of that.
    const auto sum = [&](double far) {
      return std::abs(under.height) + std::abs(move_.dz) + 8 * far +
             under.bend * far * far;
    };
    room_point_ = std::ldexp(sum(radius_ + length_), -20);
    room_node_ = std::ldexp(sum(radius_ + length_ + 2 * largest_node), -20);
  }

  /// Only values of at least @p best matter from now on.
  void demand(double best)
  {
    const double over = best - base_;
    if (flat_) {
      limit_point_ = limit_node_ = atLeast(roundDown(over));
      return;
    }
    const double room = std::ldexp(std::abs(over), -20);
    limit_point_ = atLeast(static_cast<float>(over - room - room_point_));
    limit_node_ = atLeast(static_cast<float>(over - room - room_node_));
  }

  /// From (x, y) to the axis where it passes lowest.
  double axisDistance(double x, double y) const
  {
    double u = x - move_.ax, v = y - move_.ay;
    if (kMoves) {
      const double t = std::clamp(
          (u * move_.dx + v * move_.dy) * per_length2_ - lag_, 0.0, 1.0);
      u -= t * move_.dx;
      v -= t * move_.dy;
    }
    return std::sqrt(u * u + v * v);
  }

  bool flat() const { return flat_; }
  float limit() const { return limit_node_; }

  /// Largest squared distance to the axis at which a node of this @p size can matter.
  float reach2(double size) const
  {
    const double reach = radius_ + 0.70721 * size + 1e-6 * (size + length_ + radius_);
    return static_cast<float>(reach * reach * (1 + 1e-6));
  }

  /// Nodes of a block that can matter, as bits, and a bound of each one's values.
  /// @p x, @p y: the middle of its first node from the move's start.
  template <bool kCells>
  unsigned nodes(const HeightPyramid::Level& level,
                 std::size_t block,
                 double x,
                 double y,
                 float slope_x,
                 float slope_y,
                 float reach2,
                 float* bound) const
  {
    static constexpr float across[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    static constexpr float up[] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    const auto size = static_cast<float>(level.size), half = 0.5001f * size;
    const auto x0 = static_cast<float>(x), y0 = static_cast<float>(y);
    unsigned mask = 0;
    for (int k = 0; k < HeightPyramid::kNodes; k += kLanes) {
      Floats u = load(across + k) * size + x0, v = load(up + k) * size + y0;
      Floats fall{}, near2;
      away(u, v, fall, near2);
      Floats value;
      if (flat_)
        value = load(&level.top[block + k]);
      else {
        const Floats sx = kCells ? u - u + slope_x : load(&level.slope_x[block + k]);
        const Floats sy = kCells ? u - u + slope_y : load(&level.slope_y[block + k]);
        value = load(&level.mid[block + k]) - reference_ - offset_ - fall -
                bend_ * (u * u + v * v) +
                half * (magnitude(sx - 2 * bend_ * u) + magnitude(sy - 2 * bend_ * v));
      }
      __builtin_memcpy(bound + k, &value, sizeof value);
      mask |= bitsOf((value >= limit_node_) & (near2 <= reach2)) << k;
    }
    return mask;
  }

  /// Of kLanes points in a row, those that can matter, as bits.
  unsigned points(const float* x, const float* y, const float* z) const
  {
    Floats u = load(x) - ax_ - ax_rest_, v = load(y) - ay_ - ay_rest_;
    Floats fall{}, near2;
    away(u, v, fall, near2);
    Floats value = load(z);
    if (!flat_)
      value = value - reference_ - offset_ - fall - bend_ * (u * u + v * v);
    return bitsOf((value >= limit_point_) & (near2 <= reach2_));
  }

private:
  /// From the axis where it passes lowest over (u, v), which then is how far it has
  /// sunk by `fall`; and the least squared distance.
  void away(Floats& u, Floats& v, Floats& fall, Floats& near2) const
  {
    if (!kMoves) {
      near2 = u * u + v * v;
      return;
    }
    const Floats t = (u * dx_ + v * dy_) * per_length2_;
    const Floats nearest = clamped(t);
    const Floats nu = u - nearest * dx_, nv = v - nearest * dy_;
    near2 = nu * nu + nv * nv;
    if (flat_)
      return;
    const Floats lowest = clamped(t - lag_);
    u -= lowest * dx_;
    v -= lowest * dy_;
    fall = lowest * dz_;
  }

  static float roundDown(double v)
  {
    const auto f = static_cast<float>(v);
    return f > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
  }
  static float atLeast(float v) // so that -infinity never passes
  {
    return std::max(v, std::numeric_limits<float>::lowest());
  }

  Move move_;
  double radius_, length_, base_ = 0, room_point_ = 0, room_node_ = 0;
  float ax_, ay_, ax_rest_, ay_rest_, dx_, dy_, dz_, per_length2_, lag_ = 0;
  float reference_ = 0, offset_ = 0, bend_ = 0, reach2_ = 0;
  float limit_point_ = 0, limit_node_ = 0;
  bool flat_ = true;
};

/// Finds the point of the highest value: down the pyramid, the most promising node of a
/// block first, with exact.value() for the few points that the sieve lets through.
template <bool kMoves, typename Exact>
class Hunt {
public:
  Hunt(const SearchSpace& space, const Move& move, double radius, Exact& exact)
      : points_(space.points), pyramid_(space.pyramid), frame_(space.points.frame),
        move_(move), sieve_(move, radius), exact_(exact)
  {
    // written so that NaN meets nothing
    const double x0 = std::min(0.0, move.dx) + move.ax - radius,
                 x1 = std::max(0.0, move.dx) + move.ax + radius;
    const double y0 = std::min(0.0, move.dy) + move.ay - radius,
                 y1 = std::max(0.0, move.dy) + move.ay + radius;
    misses_ = !(x1 >= points_.min.x() && y1 >= points_.min.y() &&
                x0 <= points_.max.x() && y0 <= points_.max.y());
    if (misses_)
      return;
    // Blocks about as large as the cutter: a handful covers it.
    const double wanted =
        0.5 * std::max({radius, std::abs(move.dx), std::abs(move.dy)});
    while (top_level_ + 1 < pyramid_.levels() &&
           HeightPyramid::kSide * pyramid_.level(top_level_).size < wanted)
      ++top_level_;
    const auto& level = pyramid_.level(top_level_);
    const double hair = 1e-4 * level.size;
    const auto block = [&](double at, double origin, int count) {
      const double b = std::floor((at - origin) / (HeightPyramid::kSide * level.size));
      return static_cast<int>(std::clamp(b, 0.0, count - 1.0));
    };
    i0_ = block(x0 - hair, frame_.x0, level.blocks_x);
    i1_ = block(x1 + hair, frame_.x0, level.blocks_x);
    j0_ = block(y0 - hair, frame_.y0, level.blocks_y);
    j1_ = block(y1 + hair, frame_.y0, level.blocks_y);
    for (int k = 0; k <= top_level_; ++k)
      reach2_[k] = sieve_.reach2(pyramid_.level(k).size);
  }

  bool misses() const { return misses_; }

  /// Follows the most promising nodes only, down to one cell, and asks its points.
  void seed(const Paraboloid& under)
  {
    sieve_.lean(under, points_.max.z() - move_.az, largestNode());
    sieve_.demand(-std::numeric_limits<double>::infinity());
    Node best;
    for (int j = j0_; j <= j1_; ++j)
      for (int i = i0_; i <= i1_; ++i)
        best = better(best, bestOf(top_level_, i, j));
    for (int level = top_level_; level > 0 && best.found(); --level)
      best = bestOf(level - 1, best.i, best.j);
    if (!best.found())
      return;
    guess_ = sieve_.axisDistance(frame_.x0 + (best.i + 0.5) * frame_.cell,
                                 frame_.y0 + (best.j + 0.5) * frame_.cell);
    const std::size_t cell =
        static_cast<std::size_t>(best.j) * frame_.columns + best.i;
    for (std::size_t p = points_.start[cell]; p < points_.start[cell + 1]; ++p)
      exact_.ask(p);
  }

  /// How far from the axis the seed found the highest cell.
  double guess() const { return guess_; }

  /// All points that can have more than exact.best().
  void all(const Paraboloid& under)
  {
    const double best = exact_.best();
    sieve_.lean(
        under, best > -kInfinity ? best : points_.max.z() - move_.az, largestNode());
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
    float bound = -std::numeric_limits<float>::infinity();
    int level = -1, i = 0, j = 0;
    bool found() const { return level >= 0; }
  };

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr int kMostLevels = 16; // 4^16 cells in a row are more than an int

  static const Node& better(const Node& a, const Node& b)
  {
    return b.bound > a.bound ? b : a;
  }

  double largestNode() const { return pyramid_.level(top_level_).size; }

  /// Bounds of the nodes of a block, and which of them matter.
  unsigned boundsOf(int level, int i, int j, float* bound) const
  {
    const auto& nodes = pyramid_.level(level);
    const std::size_t block = nodes.block(i, j);
    const double x =
        frame_.x0 + (HeightPyramid::kSide * i + 0.5) * nodes.size - move_.ax;
    const double y =
        frame_.y0 + (HeightPyramid::kSide * j + 0.5) * nodes.size - move_.ay;
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

  static Node
  nodeOf(int level, int i, int j, int k, const float* bound)
  {
    return {bound[k],
            level,
            HeightPyramid::kSide * i + k % HeightPyramid::kSide,
            HeightPyramid::kSide * j + k / HeightPyramid::kSide};
  }

  Node bestOf(int level, int i, int j) const
  {
    alignas(64) float bound[HeightPyramid::kNodes];
    Node best;
    for (unsigned mask = boundsOf(level, i, j, bound); mask; mask &= mask - 1)
      best = better(best, nodeOf(level, i, j, __builtin_ctz(mask), bound));
    return best;
  }

  std::uint32_t firstPoint(const Node& node) const
  {
    const std::size_t column = static_cast<std::size_t>(node.i) << 2 * node.level,
                      row = static_cast<std::size_t>(node.j) << 2 * node.level;
    return points_.start[row * frame_.columns + column];
  }

  bool matters(const Node& node) const
  {
    return sieve_.flat() ? exact_.mayBeat(node.bound, firstPoint(node))
                         : node.bound >= sieve_.limit();
  }

  /// Puts the nodes of a block that matter on the stack, the best on top, or asks the
  /// points of its cells.
  void open(int level, int i, int j)
  {
    alignas(64) float bound[HeightPyramid::kNodes];
    unsigned mask = boundsOf(level, i, j, bound);
    if (level == 0) {
      if (mask)
        look(i, j, mask, bound);
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

  void look(int i, int j, unsigned mask, const float* bound)
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
      ask(start[__builtin_ctz(cells)], start[32 - __builtin_clz(cells)]);
    }
  }

  void ask(std::size_t first, std::size_t last)
  {
    for (std::size_t p = first; p < last; p += kLanes)
      for (unsigned mask =
               sieve_.points(&points_.x[p], &points_.y[p], &points_.z[p]);
           mask;
           mask &= mask - 1) {
        exact_.ask(p + __builtin_ctz(mask));
        sieve_.demand(exact_.best());
      }
  }

  const SortedPoints& points_;
  const HeightPyramid& pyramid_;
  const CellFrame& frame_;
  Move move_;
  Sieve<kMoves> sieve_;
  Exact& exact_;
  bool misses_;
  int top_level_ = 0, i0_ = 0, i1_ = 0, j0_ = 0, j1_ = 0;
  float reach2_[kMostLevels];
  double guess_ = 0;
  int depth_ = 0;
  Node stack_[kMostLevels * HeightPyramid::kNodes];
};

void dropRow(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector2d& from,
             const Eigen::Vector2d& step,
             std::size_t count,
             Contact* contacts)
{
  const CutterUnderside underside(tool);
  std::int64_t last = -1; // where the cutter rested before
  double lean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = from.x() + static_cast<double>(i) * step.x();
    const double y = from.y() + static_cast<double>(i) * step.y();
    DropValue value(space.points, tool, x, y);
    Hunt<false, DropValue> hunt(space, {x, y, 0, 0, 0, 0}, tool.radius(), value);
    if (!hunt.misses()) {
      if (last >= 0)
        value.ask(static_cast<std::size_t>(last));
      if (!value.contact().touches()) {
        hunt.seed(underside.touching(0));
        lean = value.contact().touches() ? value.distance() : hunt.guess();
      }
      hunt.all(underside.touching(lean));
    }
    contacts[i] = value.contact();
    last = contacts[i].point;
    if (last >= 0) {
      contacts[i].at = {space.points.x[last], space.points.y[last], space.points.z[last]};
      lean = value.distance();
    }
  }
}

double dropAlong(const SearchSpace& space,
                 const Tool& tool,
                 const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b)
{
  AlongValue value(space.points, tool, a, b);
  const Move move{a.x(), a.y(), 0, b.x() - a.x(), b.y() - a.y(), 0};
  Hunt<true, AlongValue> hunt(space, move, tool.radius(), value);
  if (!hunt.misses()) {
    const CutterUnderside underside(tool);
    hunt.seed(underside.touching(0));
    hunt.all(underside.touching(hunt.guess()));
  }
  return value.best();
}

double gouge(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             double tolerance)
{
  GougeValue value(space.points, tool, a, b, tolerance);
  const Move move{a.x(), a.y(), a.z(), b.x() - a.x(), b.y() - a.y(), b.z() - a.z()};
  Hunt<true, GougeValue> hunt(space, move, tool.radius(), value);
  if (!hunt.misses()) {
    const CutterUnderside underside(tool);
    hunt.seed(underside.touching(0));
    hunt.all(underside.touching(hunt.guess()));
  }
  return value.best() > tolerance ? value.best() : 0.0;
}
