// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Part of search.cpp: drops at many places in a row.

/// Points near a stretch of the row, all that can matter to any of its places.
class Nearby {
public:
  explicit Nearby(const SortedPoints& points) : points_(points) {}

  void start(double best)
  {
    best_ = best;
    count_ = 0;
    overflow_ = false;
  }
  double best() const { return best_; }
  bool mayBeat(double, double, std::size_t) const { return true; }
  void ask(std::size_t) {}

  template <typename Sieve>
  void take(Sieve&, std::size_t first, std::size_t last)
  {
    if (last - first > kMost - count_) {
      overflow_ = true;
      return;
    }
    // In whole vectors: what is too much is overwritten by the next run, or by close().
    for (std::size_t p = first; p < last; p += kLanes) {
      const std::size_t to = count_ + (p - first);
      copy(&points_.x[p], x_ + to);
      copy(&points_.y[p], y_ + to);
      copy(&points_.z[p], z_ + to);
      for (std::size_t k = 0; k < kLanes; ++k)
        point_[to + k] = static_cast<std::uint32_t>(p + k);
    }
    count_ += last - first;
  }

  /// False where there were too many.
  bool close()
  {
    std::fill_n(z_ + count_, kLanes, -std::numeric_limits<float>::infinity());
    return !overflow_;
  }
  void sift(Sieve<false>& sieve, DropValue& value) const
  {
    sieve.sift(x_, y_, z_, count_, value, [&](auto k) { return point_[k]; });
  }

private:
  static constexpr std::size_t kMost = 2048;

  static void copy(const float* from, float* to)
  {
    __builtin_memcpy(to, from, kLanes * sizeof(float));
  }

  const SortedPoints& points_;
  double best_ = 0;
  std::size_t count_ = 0;
  bool overflow_ = false;
  alignas(64) float x_[kMost + kLanes], y_[kMost + kLanes], z_[kMost + kLanes];
  std::uint32_t point_[kMost + kLanes];
};

/// Drops a cutter, and remembers how it came to rest.
class Drops {
public:
  Drops(const SearchSpace& space, const Tool& tool)
      : pyramid_(space.pyramid), points_(space.points), cutter_(tool), underside_(tool),
        value_(space.points, cutter_), hunt_(space, {}, tool.radius())
  {
  }

  Contact drop(const Eigen::Vector2d& at)
  {
    value_.startAt(at);
    if (hunt_.startAt(at.x(), at.y(), value_))
      hunt_.all(hunt_.seed(underside_));
    return keep(value_, at);
  }

  Contact keep(const DropValue& value, const Eigen::Vector2d& at)
  {
    const Contact contact = value.contact();
    last_ = contact.point;
    if (contact.touches()) {
      tip_ = contact.tip;
      offset_ = contact.at.head<2>() - at;
    }
    return contact;
  }

  bool touched() const { return last_ >= 0; }
  std::size_t point() const { return static_cast<std::size_t>(last_); }
  double tip() const { return tip_; }
  const CutterUnderside& underside() const { return underside_; }
  Eigen::Vector2d contactOffset(const Eigen::Vector2d& at) const
  {
    return contactFrom(pyramid_, points_.frame, underside_, at, offset_);
  }

  const Cutter& cutter() const { return cutter_; }

private:
  const HeightPyramid& pyramid_;
  const SortedPoints& points_;
  Cutter cutter_;
  CutterUnderside underside_;
  Exactly<DropValue> value_;
  Hunt<false, Exactly<DropValue>> hunt_;
  std::int64_t last_ = -1;
  double tip_ = 0;
  Eigen::Vector2d offset_{0, 0};
};

/// Drops a cutter at places in a row that are near each other. The search goes down the
/// pyramid once for a stretch of them, as for a move over that stretch just under the
/// heights that are known to be reached.
class Stretches {
public:
  static constexpr int kPlaces = 8; ///< of a stretch

  Stretches(const SearchSpace& space,
            const Tool& tool,
            const Eigen::Vector2d& from,
            const Eigen::Vector2d& step,
            Drops& drops)
      : points_(space.points), from_(from), step_(step), drops_(drops),
        deepest_(kDeepest * tool.radius()),
        values_(kPlaces, DropValue(space.points, drops.cutter())),
        hunt_(space,
              {0, 0, 0, (kPlaces - 1) * step.x(), (kPlaces - 1) * step.y(), 0},
              tool.radius()),
        sieve_({}, tool.radius()), nearby_(space.points)
  {
  }

  /// Whether places so far apart are near each other.
  static bool suits(const Tool& tool, const Eigen::Vector2d& step)
  {
    return (kPlaces - 1) * step.norm() <= 0.6 * tool.radius();
  }

  /// Drops at the places from number @p i on. False, and nothing is done, where the
  /// ground is too rough to do it at once.
  bool drop(std::size_t i, Contact* contacts)
  {
    offset_ = drops_.contactOffset(place(i + kPlaces / 2));
    const Paraboloid under = drops_.underside().touching(offset_.norm());
    sieve_.lean(under, drops_.tip(), 0);
    if (sieve_.flat())
      return false;
    for (int k = 0; k < kPlaces; ++k)
      if (!glance(place(i + k), values_[k]))
        return false;
    const double first = values_.front().best(), rise = values_.back().best() - first;
    double sag = 0; // under the chord over the stretch
    for (int k = 1; k + 1 < kPlaces; ++k)
      sag = std::max(sag, first + rise * k / (kPlaces - 1) - values_[k].best());
    if (sag > deepest_)
      return false;
    const Eigen::Vector2d start = place(i);
    nearby_.start(-sag);
    hunt_.tilt(first, rise);
    if (!hunt_.startAt(start.x(), start.y(), nearby_))
      return false;
    hunt_.all(under);
    if (!nearby_.close())
      return false;
    for (int k = 0; k < kPlaces; ++k) {
      const Eigen::Vector2d at = place(i + k);
      sieve_.startAt(at.x(), at.y());
      sieve_.demand(values_[k].best());
      nearby_.sift(sieve_, values_[k]);
      contacts[k] = drops_.keep(values_[k], at);
    }
    return true;
  }

private:
  static constexpr double kDeepest = 0.1; // sag, in radii of the cutter

  Eigen::Vector2d place(std::size_t i) const
  {
    return from_ + static_cast<double>(i) * step_;
  }

  /// Rests on a good point, likely the best: near where the last one was, moved along.
  /// False where there is none.
  bool glance(const Eigen::Vector2d& at, DropValue& value)
  {
    const CellFrame& frame = points_.frame;
    const Eigen::Vector2d there = at + offset_;
    const std::size_t first =
        points_.start[static_cast<std::size_t>(frame.row(there.y())) * frame.columns +
                      frame.column(there.x())];
    sieve_.startAt(at.x(), at.y());
    value.startAt(at);
    const int k =
        sieve_.highest(&points_.x[first], &points_.y[first], &points_.z[first]);
    value.ask(k < 0 ? drops_.point() : first + static_cast<std::size_t>(k));
    return value.touches();
  }

  const SortedPoints& points_;
  Eigen::Vector2d from_, step_;
  Drops& drops_;
  double deepest_;
  Eigen::Vector2d offset_{0, 0}; // of the contact from the axis, about
  std::vector<DropValue> values_;
  Hunt<true, Nearby> hunt_;
  Sieve<false> sieve_;
  Nearby nearby_;
};

void dropRow(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector2d& from,
             const Eigen::Vector2d& step,
             std::size_t count,
             Contact* contacts)
{
  Drops drops(space, tool);
  std::size_t i = 0;
  const auto dropUntil = [&](std::size_t stop) {
    for (; i < stop; ++i)
      contacts[i] = drops.drop(from + static_cast<double>(i) * step);
  };
  if (count > Stretches::kPlaces && Stretches::suits(tool, step)) {
    Stretches stretches(space, tool, from, step, drops);
    while (i + Stretches::kPlaces <= count) {
      const std::size_t stop = i + Stretches::kPlaces;
      if (drops.touched() && stretches.drop(i, contacts + i))
        i = stop;
      dropUntil(stop);
    }
  }
  dropUntil(count);
}
