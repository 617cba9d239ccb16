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
  bool mayBeat(double, std::size_t) const { return true; }
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
    siftColumns(sieve, x_, y_, z_, count_, value, [&](auto k) { return point_[k]; });
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

/// Drops a cutter at places in a row. Where they are near each other, the search goes
/// down the pyramid once for a stretch of them, as for a move over that stretch just
/// under the heights that are known to be reached.
class RowOfDrops {
public:
  RowOfDrops(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector2d& from,
             const Eigen::Vector2d& step)
      : points_(space.points), from_(from), step_(step), underside_(tool),
        deepest_(kDeepest * tool.radius()),
        near_((kStretch - 1) * step.norm() <= kLongest * tool.radius()),
        values_(kStretch, Exactly<DropValue>(space.points, tool)),
        single_(space, {}, tool.radius()),
        stretch_(space, overStretch(step), tool.radius()), sieve_({}, tool.radius()),
        nearby_(space.points)
  {
  }

  void drop(std::size_t count, Contact* contacts)
  {
    for (std::size_t i = 0; i < count;) {
      const std::size_t stop = std::min(count, i + kStretch);
      if (near_ && last_ >= 0 && stop == i + kStretch && dropStretch(i, contacts + i))
        i = stop;
      for (; i < stop; ++i)
        dropOne(i, contacts[i]);
    }
  }

private:
  static constexpr int kStretch = 8;
  static constexpr double kLongest = 0.6; // stretch, and how far it may sag
  static constexpr double kDeepest = 0.1; // under its chord, in radii of the cutter

  static Move overStretch(const Eigen::Vector2d& step)
  {
    return {0, 0, 0, (kStretch - 1) * step.x(), (kStretch - 1) * step.y(), 0};
  }

  Eigen::Vector2d place(std::size_t i) const
  {
    return from_ + static_cast<double>(i) * step_;
  }

  void keep(const DropValue& value, const Eigen::Vector2d& at, Contact& contact)
  {
    contact = value.contact();
    last_ = contact.point;
    if (contact.touches())
      offset_ = contact.at.head<2>() - at;
  }

  void dropOne(std::size_t i, Contact& contact)
  {
    const Eigen::Vector2d at = place(i);
    auto& value = values_[0];
    value.startAt(at);
    if (single_.startAt(at.x(), at.y(), value)) {
      double lean = offset_.norm();
      if (last_ >= 0)
        value.ask(static_cast<std::size_t>(last_));
      if (!value.touches()) {
        single_.seed(underside_.touching(0));
        lean = single_.guess();
      }
      single_.all(underside_.touching(lean));
    }
    keep(value, at, contact);
  }

  bool dropStretch(std::size_t i, Contact* contacts)
  {
    Paraboloid under = underside_.touching(offset_.norm());
    const double base = contacts[-1].tip;
    sieve_.lean(under, base, 0);
    if (sieve_.flat())
      return false;
    for (int k = 0; k < kStretch; ++k)
      if (!glance(place(i + k), values_[k]))
        return false;
    const double first = values_[0].best(), rise = values_[kStretch - 1].best() - first;
    double sag = 0;
    for (int k = 1; k + 1 < kStretch; ++k)
      sag = std::max(sag, first + rise * k / (kStretch - 1) - values_[k].best());
    if (sag > deepest_)
      return false;
    nearby_.start(-sag);
    stretch_.tilt(first, rise);
    const Eigen::Vector2d start = place(i);
    if (!stretch_.startAt(start.x(), start.y(), nearby_))
      return false;
    stretch_.all(under);
    if (!nearby_.close())
      return false;
    for (int k = 0; k < kStretch; ++k) {
      const Eigen::Vector2d at = place(i + k);
      sieve_.startAt(at.x(), at.y());
      sieve_.demand(values_[k].best());
      nearby_.sift(sieve_, values_[k]);
      keep(values_[k], at, contacts[k]);
    }
    return true;
  }

  /// Rests on a good point, likely the best: near where the last one was, moved along.
  /// False where there is none.
  bool glance(const Eigen::Vector2d& at, DropValue& value)
  {
    const CellFrame& frame = points_.frame;
    const int row = frame.row(at.y() + offset_.y()),
              column = frame.column(at.x() + offset_.x());
    const std::size_t first =
        points_.start[static_cast<std::size_t>(row) * frame.columns + column];
    sieve_.startAt(at.x(), at.y());
    value.startAt(at);
    const int k =
        sieve_.highest(&points_.x[first], &points_.y[first], &points_.z[first]);
    value.ask(k < 0 ? static_cast<std::size_t>(last_) : first + k);
    return value.touches();
  }

  const SortedPoints& points_;
  Eigen::Vector2d from_, step_;
  CutterUnderside underside_;
  double deepest_;
  bool near_;
  std::vector<Exactly<DropValue>> values_;
  Hunt<false, Exactly<DropValue>> single_;
  Hunt<true, Nearby> stretch_;
  Sieve<false> sieve_;
  Nearby nearby_;
  std::int64_t last_ = -1;          // the point that the cutter rested on before,
  Eigen::Vector2d offset_ = {0, 0}; // and where that was from the axis
};

void dropRow(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector2d& from,
             const Eigen::Vector2d& step,
             std::size_t count,
             Contact* contacts)
{
  RowOfDrops(space, tool, from, step).drop(count, contacts);
}
