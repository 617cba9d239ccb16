// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_fit.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

using Eigen::Vector2d;

/// Shorter ones would have a centre that is mostly rounding [ticks].
constexpr double shortest_arc = 100.0;

/// The bulges of all arcs from a to b that pass by some points.
class BulgeRange {
public:
  BulgeRange(const Vector2d& a, const Vector2d& b, double largest, double tolerance)
      : a_(a), b_(b), reach_(tolerance * (b - a).norm()), low_(-largest), high_(largest)
  {
  }

  /// False where no arc is left.
  bool passBy(const Vector2d& p)
  {
    const Vector2d a = a_ - p, b = b_ - p;
    const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
    if (lengths <= reach_)
      return true; // at an end, which all arcs share
    const double facing = lengths - a.dot(b);
    if (!(facing > 0))
      return false; // in line with the ends and beyond them
    // The ends are seen from p under pi less half of the sweep. In bipolar coordinates
    // about them that angle's scale is lengths / |b - a|.
    const double bulge = cross(b, a) / facing;
    const double margin = (1.0 + bulge * bulge) / 2 * (reach_ / lengths);
    low_ = std::max(low_, bulge - margin);
    high_ = std::min(high_, bulge + margin);
    return low_ <= high_;
  }

  bool has(double bulge) const { return bulge >= low_ && bulge <= high_; }
  double middle() const { return (low_ + high_) / 2; }

private:
  Vector2d a_, b_;
  double reach_;
  double low_, high_;
};

/// The bulge of an arc of that radius, of half a turn at most, over half a chord.
double bulgeOf(double radius, double half)
{
  return half < radius ? half / (radius + std::sqrt(radius * radius - half * half))
                       : 1.0;
}

/// The nearest bulge whose arc, where it is half a turn at most, has an allowed radius.
/// Rounding the centre changes that by less than a tick.
double withRadius(double bulge, double half, const ArcLimits& limits)
{
  const double flattest = bulgeOf(limits.largest_radius - 1, half);
  const double roundest = bulgeOf(limits.smallest_radius + 1, half);
  const double size = std::abs(bulge);
  if (size > 1)
    return bulge;
  return std::copysign(std::min(std::max(size, flattest), roundest), bulge);
}

} // namespace

std::optional<double>
commonBulge(const Polyline& line, const PlaneAxes& axes, const ArcLimits& limits)
{
  const Vector2d first = axes.project(line.front()), last = axes.project(line.back());
  BulgeRange range(first, last, std::tan(limits.largest_sweep / 4), limits.tolerance);
  Vector2d at = first;
  for (std::size_t i = 1; i < line.size; ++i) {
    const Vector2d next = axes.project(line[i]);
    if (!range.passBy((at + next) / 2) || (i + 1 < line.size && !range.passBy(next)))
      return std::nullopt;
    at = next;
  }
  const double bulge = withRadius(range.middle(), (last - first).norm() / 2, limits);
  if (range.has(0.0) || !range.has(bulge)) // straight in this plane: an arc is no help
    return std::nullopt;
  return bulge;
}

std::optional<FittedArc>
fitArc(const Polyline& line, ArcPlane plane, const ArcLimits& limits)
{
  const PlaneAxes axes = axesOf(plane);
  const Vector2d chord = axes.project(line.back() - line.front());
  if (chord.norm() < shortest_arc)
    return std::nullopt;
  const auto bulge = commonBulge(line, axes, limits);
  if (!bulge)
    return std::nullopt;

  const Vector2d left(-chord.y(), chord.x());
  const Vector2d centre = chord / 2 + left * ((1.0 - *bulge * *bulge) / (4 * *bulge));
  FittedArc fit;
  fit.arc.to = toPosition(line.back());
  fit.arc.plane = plane;
  fit.arc.clockwise = *bulge < 0;
  fit.arc.u = std::llround(centre.x());
  fit.arc.v = std::llround(centre.y());
  fit.deviation = arcDeviation(line, fit.arc, limits);
  if (!std::isfinite(fit.deviation))
    return std::nullopt;
  return fit;
}

} // namespace pointmill::gcode
