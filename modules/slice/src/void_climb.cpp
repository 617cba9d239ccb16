// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "void_climb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;

constexpr int kMostMeetings = 32; // far more than are ever needed
constexpr double kEqual = 1e-9;   // of the radius

/// Points on a void's border; more than there is room for are on circles of regular
/// grids only, where the others tell the same.
class Border {
public:
  void add(const Vector2d& p)
  {
    if (count_ < points_.size())
      points_[count_++] = p;
  }
  const Vector2d& front() const { return points_.front(); }

  /// Turns to the middle of the gap between them that is half a circle or more, seen
  /// from `v.at`, and keeps the two points beside it. False where there is none.
  bool leave(const Void& v, Vector2d& direction)
  {
    // All others lie to the right of the one before such a gap, and to the left of the
    // one after it. No angles: their functions round differently on other machines.
    const auto turn = [&](std::size_t i, std::size_t k) {
      const Vector2d a = points_[i] - v.at, b = points_[k] - v.at;
      return a.x() * b.y() - a.y() * b.x();
    };
    const double equal = kEqual * v.radius * v.radius;
    std::size_t before = count_, after = count_;
    for (std::size_t i = 0; i < count_; ++i) {
      bool left = true, right = true;
      for (std::size_t k = 0; k < count_; ++k) {
        left &= turn(i, k) >= -equal;
        right &= turn(i, k) <= equal;
      }
      if (right && before == count_)
        before = i;
      else if (left && after == count_)
        after = i;
    }
    if (before == count_)
      return false;
    const Vector2d first = points_[before];
    const bool alone = after == count_;
    const Vector2d second = alone ? first : points_[after];
    if (!alone)
      direction = Vector2d(second.y() - first.y(), first.x() - second.x()).normalized();
    else if (v.radius > 0)
      direction = (v.at - first) / v.radius;
    else
      direction = Vector2d::UnitX();
    count_ = 0;
    add(first);
    if (!alone)
      add(second);
    return true;
  }

private:
  std::array<Vector2d, 10> points_;
  std::size_t count_ = 0;
};

/// Moves the void's middle along the unit vector `u`, its border on what it holds,
/// until it meets others, which it then holds too. Returns how far.
double nextMeeting(const PointBuckets& buckets,
                   const Void& v,
                   const Vector2d& u,
                   double most,
                   Border& border)
{
  const Vector2d held = border.front();
  double least = most;
  std::array<Vector2d, 8> met;
  std::size_t count = 0;
  buckets.walk(
      v.at.x(),
      v.at.y(),
      // Having gone t, the disc is within radius + 2 t of where it was.
      [&](double reached) { return reached < v.radius + 2 * least; },
      [&](const Eigen::Vector3f& p, std::uint32_t) {
        const Vector2d other = p.head<2>().cast<double>();
        const double nearing = 2 * u.dot(other - held);
        if (nearing <= kEqual * v.radius)
          return; // falls behind, or is held
        const double lead = (v.at - other).squaredNorm() - v.radius * v.radius;
        const double way = std::max(0.0, lead / nearing);
        if (way > least + kEqual * v.radius)
          return;
        if (way < least - kEqual * v.radius)
          count = 0;
        least = std::min(least, way);
        if (count < met.size())
          met[count++] = other;
      });
  for (std::size_t i = 0; i < count; ++i)
    border.add(met[i]);
  return least;
}

} // namespace

Void climbVoid(const PointBuckets& buckets,
               const Vector2d& from,
               const std::function<bool(const Vector2d&)>& allowed)
{
  Void v{from, std::numeric_limits<double>::infinity()};
  Vector2d nearest = from;
  buckets.walk(
      from.x(),
      from.y(),
      [&](double reached) { return reached < v.radius; },
      [&](const Eigen::Vector3f& p, std::uint32_t) {
        const Vector2d other = p.head<2>().cast<double>();
        const double d = (other - from).norm();
        if (d < v.radius) {
          v.radius = d;
          nearest = other;
        }
      });
  Border border;
  border.add(nearest);
  const CellGrid& grid = buckets.grid();
  const double most = grid.cell * (grid.columns + grid.rows);
  Vector2d direction;
  for (int k = 0; k < kMostMeetings && border.leave(v, direction); ++k) {
    const double way = nextMeeting(buckets, v, direction, most, border);
    const Vector2d at = v.at + way * direction;
    if (way >= most || !allowed(at))
      break;
    v = {at, (at - border.front()).norm()};
  }
  return v;
}

} // namespace pointmill
