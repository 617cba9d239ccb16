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
  void clear() { count_ = 0; }
  void add(const Vector2d& p)
  {
    if (count_ < points_.size())
      points_[count_++] = p;
  }
  const Vector2d& front() const { return points_.front(); }

  /// Turns to the middle of the widest gap seen from `at` and keeps the two points
  /// beside it. False where no gap is half a circle wide.
  bool leave(const Vector2d& at, Vector2d& direction)
  {
    std::array<std::pair<double, std::size_t>, 10> seen;
    for (std::size_t i = 0; i < count_; ++i)
      seen[i] = {std::atan2(points_[i].y() - at.y(), points_[i].x() - at.x()), i};
    std::sort(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(count_));
    double widest = 0;
    std::size_t before = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double next = i + 1 < count_ ? seen[i + 1].first : seen[0].first + 2 * M_PI;
      if (next - seen[i].first > widest) {
        widest = next - seen[i].first;
        before = i;
      }
    }
    if (widest < M_PI - kEqual)
      return false;
    const double middle = seen[before].first + widest / 2;
    direction = {std::cos(middle), std::sin(middle)};
    const Vector2d first = points_[seen[before].second];
    const Vector2d second = points_[seen[(before + 1) % count_].second];
    const bool alone = count_ == 1;
    clear();
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
  for (int k = 0; k < kMostMeetings && border.leave(v.at, direction); ++k) {
    const double way = nextMeeting(buckets, v, direction, most, border);
    const Vector2d at = v.at + way * direction;
    if (way >= most || !allowed(at))
      break;
    v = {at, (at - border.front()).norm()};
  }
  return v;
}

} // namespace pointmill
