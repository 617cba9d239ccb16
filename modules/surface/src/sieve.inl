// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Part of search.cpp: sorting out many points, or nodes of the pyramid, at once.

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
/// paraboloid under the cutter, which any slope of the ground is held against; or,
/// where the cutter's bottom is flat, by height alone, which is exact.
template <bool kMoves>
class Sieve {
public:
  Sieve(const Move& move, double radius) : move_(move), radius_(radius)
  {
    length_ = std::sqrt(move.dx * move.dx + move.dy * move.dy);
    if (length_ < kVertical)
      length_ = move_.dx = move_.dy = 0;
    dx_ = static_cast<float>(move_.dx);
    dy_ = static_cast<float>(move_.dy);
    dz_ = static_cast<float>(move_.dz);
    per_length2_ = static_cast<float>(length_ > 0 ? 1 / (length_ * length_) : 0.0);
    reach2_ = reach2(0.0);
    startAt(move.ax, move.ay);
  }

  /// From another height, to one that is higher by dz.
  void tilt(double az, double dz)
  {
    move_.az = az;
    move_.dz = dz;
    dz_ = static_cast<float>(dz);
  }

  /// The same move from another place.
  void startAt(double ax, double ay)
  {
    move_.ax = ax;
    move_.ay = ay;
    ax_ = static_cast<float>(ax);
    ay_ = static_cast<float>(ay);
    ax_rest_ = static_cast<float>(ax - ax_);
    ay_rest_ = static_cast<float>(ay - ay_);
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
    // The lowest pass over a place is not where the axis is nearest, but lower down; of
    // a plunge it is the end.
    const double lag = length_ > 0    ? move_.dz / (2 * under.bend * length_ * length_)
                       : move_.dz < 0 ? -1.0
                                      : 0.0;
    lag_ = static_cast<float>(lag);
    // What the terms of a bound can add up to where it is near zero; each of the few
    // operations rounds by 2^-24 of that.
    const auto sum = [&](double far) {
      return std::abs(under.height) + std::abs(move_.dz) + 8 * far +
             under.bend * far * far;
    };
    room_point_ = kRounding * sum(radius_ + length_);
    room_node_ = kRounding * sum(radius_ + length_ + 2 * largest_node);
  }

  /// Only values of at least @p best matter from now on.
  void demand(double best)
  {
    const double over = best - base_;
    if (flat_) {
      limit_point_ = limit_node_ = atLeast(roundDown(over));
      return;
    }
    const double room = kRounding * std::abs(over);
    limit_point_ = atLeast(static_cast<float>(over - room - room_point_));
    limit_node_ = atLeast(static_cast<float>(over - room - room_node_));
  }

  /// Only nodes with bounds of at least @p bound.
  void demandOfNodes(float bound) { limit_node_ = bound; }

  bool flat() const { return flat_; }
  float limit() const { return limit_node_; }
  const Move& move() const { return move_; }

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
      Floats rise{}, near2;
      away(u, v, rise, near2);
      Floats value;
      if (flat_)
        value = load(&level.top[block + k]);
      else {
        const Floats sx = kCells ? u - u + slope_x : load(&level.slope_x[block + k]);
        const Floats sy = kCells ? u - u + slope_y : load(&level.slope_y[block + k]);
        value = load(&level.mid[block + k]) - reference_ - offset_ - rise -
                bend_ * (u * u + v * v) +
                half * (magnitude(sx - 2 * bend_ * u) + magnitude(sy - 2 * bend_ * v));
      }
      __builtin_memcpy(bound + k, &value, sizeof value);
      mask |= within(value, limit_node_, near2, reach2) << k;
    }
    return mask;
  }

  /// Has value.ask(pointAt(k)) called for the points of columns that can matter, as far
  /// as the best of those before lets them.
  template <typename Value, typename PointAt>
  void sift(const float* x,
            const float* y,
            const float* z,
            std::size_t count,
            Value& value,
            PointAt&& pointAt)
  {
    const Sieve here(*this); // which asking cannot change
    alignas(64) float bound[kLanes];
    float limit = limit_point_;
    for (std::size_t p = 0; p < count; p += kLanes) {
      Floats near2;
      const Floats bounds = here.valuesOf(x + p, y + p, z + p, near2);
      unsigned mask = within(bounds, limit, near2, here.reach2_);
      if (!mask)
        continue;
      __builtin_memcpy(bound, &bounds, sizeof bounds);
      for (; mask; mask &= mask - 1) {
        const unsigned k = __builtin_ctz(mask);
        if (bound[k] < limit)
          continue;
        value.ask(pointAt(p + k));
        demand(value.best());
        limit = limit_point_;
      }
    }
  }

  /// The one of kLanes points in a row with the highest bound, -1 where all are out of
  /// reach.
  int highest(const float* x, const float* y, const float* z) const
  {
    Floats near2;
    Floats value = valuesOf(x, y, z, near2);
    const Floats zero{}, lowest = zero + std::numeric_limits<float>::lowest();
    value = near2 <= zero + reach2_ ? value : lowest;
    const float top = largest(value);
    if (!(top > lowest[0]))
      return -1;
    return __builtin_ctz(within(value, top, zero, 0.f));
  }

private:
  Floats valuesOf(const float* x, const float* y, const float* z, Floats& near2) const
  {
    Floats u = load(x) - ax_ - ax_rest_, v = load(y) - ay_ - ay_rest_, rise{};
    away(u, v, rise, near2);
    if (flat_)
      return load(z);
    return load(z) - reference_ - offset_ - rise - bend_ * (u * u + v * v);
  }

  /// From the axis where it passes lowest over (u, v), which then has risen by `rise`;
  /// and the least squared distance.
  void away(Floats& u, Floats& v, Floats& rise, Floats& near2) const
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
    rise = lowest * dz_;
  }

  static constexpr double kRounding = 1.0 / (1 << 20);
  static constexpr double kVertical = 1e-12; // no way in XY at all [mm]

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
