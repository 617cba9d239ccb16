// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill::gcode {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double refused = std::numeric_limits<double>::infinity();
const double pi = std::acos(-1.0);

/// One chord about the centre of an arc, from @ref p to @ref q: its place at part t of
/// its length is p + t d, and @ref foot the t of its place nearest to the centre.
struct ChordAboutCentre {
  Vector2d p, q, d;
  double turn;   ///< of p to q times both lengths, positive the arc's way round
  double length; ///< of d
  double foot;

  ChordAboutCentre(const Vector2d& from, const Vector2d& to, double sense)
      : p(from), q(to), d(to - from), turn(sense * cross(from, to)), length(d.norm()),
        foot(-p.dot(d) / d.squaredNorm())
  {
  }
  /// Less than a quarter turn, and forwards.
  bool advances() const { return turn > 0 && p.dot(q) > 0; }
  double angle() const { return std::atan2(turn, p.dot(q)); }
  /// From the centre to the straight line through the chord.
  double distance() const { return turn / length; }
  double nearest(double at_p, double at_q) const
  {
    return foot > 0 && foot < 1 ? distance() : std::min(at_p, at_q);
  }
};

/// The largest |low + t rise - slope angle(t)| along a chord, where angle(t) is how far
/// it has turned at part t of its length: the error of a helix that climbs evenly with
/// the angle against a chord that climbs evenly with the length.
double
climbError(const ChordAboutCentre& chord, double begin, double rise, double slope)
{
  double most =
      std::max(std::abs(begin), std::abs(begin + rise - slope * chord.angle()));
  // Where both climb alike: rise / slope = d(angle)/dt = l h / (h^2 + l^2 (t -
  // foot)^2).
  const double l = chord.length, h = chord.distance();
  const double off = (slope * l * h / rise - h * h) / (l * l);
  if (!(off > 0))
    return most;
  for (const double t : {chord.foot - std::sqrt(off), chord.foot + std::sqrt(off)})
    if (t > 0 && t < 1) {
      const double angle =
          std::atan2((t - chord.foot) * l, h) + std::atan2(chord.foot * l, h);
      most = std::max(most, std::abs(begin + t * rise - slope * angle));
    }
  return most;
}

/// The angle from a to b in the sense of the arc, in [0, 2 pi).
double sweepOf(const Vector2d& a, const Vector2d& b, double sense)
{
  const double angle = std::atan2(sense * cross(a, b), a.dot(b));
  return angle < 0 ? angle + 2 * pi : angle;
}

} // namespace

double straightDeviation(const Polyline& line, double tolerance)
{
  const Vector3d along = line.back() - line.front();
  const double squared = along.squaredNorm();
  if (!(squared > 0))
    return refused;
  // Each point and its foot on the chord: the distance between two moves that go evenly
  // from one such pair to the next is convex, so the ends tell.
  double largest = 0.0, reached = 0.0;
  for (std::size_t i = 1; i + 1 < line.size; ++i) {
    const Vector3d p = line[i] - line.front();
    const double done = p.dot(along);
    const double off = (p - along * (done / squared)).squaredNorm();
    if (done < reached || done > squared || off > tolerance * tolerance)
      return refused;
    reached = done;
    largest = std::max(largest, off);
  }
  return std::sqrt(largest);
}

double
arcDeviation(const Polyline& line, const MachineArc& arc, const ArcLimits& limits)
{
  const PlaneAxes axes(arc.plane);
  const double sense = arc.clockwise ? -1.0 : 1.0;
  const Vector2d centre =
      axes.project(line.front()) +
      Vector2d(static_cast<double>(arc.u), static_cast<double>(arc.v));
  const Vector2d begin = axes.project(line.front()) - centre;
  const Vector2d end = axes.project(line.back()) - centre;
  const double low = std::min(begin.norm(), end.norm());
  const double high = std::max(begin.norm(), end.norm());
  const double sweep = sweepOf(begin, end, sense);
  const double climb = line.back()[axes.w] - line.front()[axes.w];
  if (low < limits.smallest_radius || high > limits.largest_radius ||
      high - low > limits.mismatch || !(sweep > 0) || sweep > limits.largest_sweep ||
      std::abs(climb) > limits.steepest * low * sweep)
    return refused;

  // The place on the arc for each place of the line is the one at the same angle, where
  // the machine's radius is between those of both ends.
  const double slope = climb / sweep;
  const double most = limits.tolerance * limits.tolerance;
  double largest = 0.0, angle = 0.0, radius = begin.norm();
  Vector2d at = begin;
  for (std::size_t i = 1; i < line.size; ++i) {
    const ChordAboutCentre chord(at, axes.project(line[i]) - centre, sense);
    // The second: round past the start once more.
    if (!chord.advances() ||
        (sense * cross(begin, at) < 0 && sense * cross(begin, chord.q) >= 0))
      return refused;
    const double next = chord.q.norm();
    const double in_plane =
        std::max(std::max(radius, next) - low, high - chord.nearest(radius, next));
    const double lift = line[i - 1][axes.w] - line.front()[axes.w] - slope * angle;
    const double rise = line[i][axes.w] - line[i - 1][axes.w];
    double across = std::max(std::abs(lift), std::abs(lift + rise));
    if (climb != 0.0) {
      across = climbError(chord, lift, rise, slope);
      angle += chord.angle();
    }
    const double off = in_plane * in_plane + across * across;
    if (off > most)
      return refused;
    largest = std::max(largest, off);
    at = chord.q;
    radius = next;
  }
  return std::sqrt(largest);
}

} // namespace pointmill::gcode
