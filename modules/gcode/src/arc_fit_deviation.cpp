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

/// The largest |begin + t rise - slope angle(t)| along a chord, where angle(t) is how
/// far it has turned at part t of its length: the error of a helix, which climbs evenly
/// with the angle, against a chord, which does with its length.
double
climbError(const ChordAboutCentre& chord, double begin, double rise, double slope)
{
  if (slope == 0.0)
    return std::max(std::abs(begin), std::abs(begin + rise));
  double most =
      std::max(std::abs(begin), std::abs(begin + rise - slope * chord.angle()));
  // Largest where both climb alike: rise = slope d(angle)/dt, which for a line at the
  // distance h is slope l h / (h^2 + l^2 (t - foot)^2).
  const double l = chord.length, h = chord.distance();
  const double squared = (slope * l * h / rise - h * h) / (l * l);
  if (!(squared > 0))
    return most;
  for (const double off : {-std::sqrt(squared), std::sqrt(squared)}) {
    const double t = chord.foot + off;
    if (t > 0 && t < 1) {
      const double angle = std::atan2(off * l, h) + std::atan2(chord.foot * l, h);
      most = std::max(most, std::abs(begin + t * rise - slope * angle));
    }
  }
  return most;
}

/// The machine's way on an arc that stands for a polyline, seen from its centre.
struct Way {
  PlaneAxes axes;
  double sense; ///< 1: counter-clockwise, -1: clockwise
  Vector2d centre, begin, end;
  double low, high; ///< radii between which the machine may be
  double sweep;     ///< [0, 2 pi)
  double climb;     ///< along the axis

  Way(const Polyline& line, const MachineArc& arc)
      : axes(axesOf(arc.plane)), sense(arc.clockwise ? -1.0 : 1.0),
        centre(axes.project(line.front()) +
               Vector2d(static_cast<double>(arc.u), static_cast<double>(arc.v))),
        begin(axes.project(line.front()) - centre),
        end(axes.project(line.back()) - centre),
        low(std::min(begin.norm(), end.norm())),
        high(std::max(begin.norm(), end.norm())),
        sweep(std::atan2(sense * cross(begin, end), begin.dot(end))),
        climb(line.back()[axes.w] - line.front()[axes.w])
  {
    if (sweep < 0)
      sweep += 2 * pi;
  }

  bool keeps(const ArcLimits& limits) const
  {
    return low >= limits.smallest_radius && high <= limits.largest_radius &&
           high - low <= limits.mismatch && sweep > 0 &&
           sweep <= limits.largest_sweep &&
           std::abs(climb) <= limits.steepest * low * sweep && dip() >= limits.floor;
  }

  /// The lowest Z on the way where that is between its ends; otherwise infinite.
  double dip() const
  {
    const Vector2d down = -axes.project(Vector3d::UnitZ());
    const double turn = std::atan2(sense * cross(begin, down), begin.dot(down));
    const bool passes = axes.w != 2 && (turn < 0 ? turn + 2 * pi : turn) < sweep;
    return passes ? -centre.dot(down) - high : std::numeric_limits<double>::infinity();
  }

  /// Whether a chord that advances comes round to where the arc begins.
  bool closes(const ChordAboutCentre& chord) const
  {
    return sense * cross(begin, chord.p) < 0 && sense * cross(begin, chord.q) >= 0;
  }

  /// How far a chord is from the way in the plane, at the same angle.
  double offInPlane(const ChordAboutCentre& chord) const
  {
    const double at_p = chord.p.norm(), at_q = chord.q.norm();
    return std::max(std::max(at_p, at_q) - low, high - chord.nearest(at_p, at_q));
  }
};

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
  const Way way(line, arc);
  if (!way.keeps(limits))
    return refused;
  const double slope = way.climb / way.sweep;
  double largest = 0.0, angle = 0.0;
  Vector2d at = way.begin;
  for (std::size_t i = 1; i < line.size; ++i) {
    const ChordAboutCentre chord(at, way.axes.project(line[i]) - way.centre, way.sense);
    if (!chord.advances() || way.closes(chord))
      return refused;
    const double in_plane = way.offInPlane(chord);
    const double begin = line[i - 1][way.axes.w] - line.front()[way.axes.w];
    const double rise = line[i][way.axes.w] - line[i - 1][way.axes.w];
    const double along = climbError(chord, begin - slope * angle, rise, slope);
    const double off = in_plane * in_plane + along * along;
    if (off > limits.tolerance * limits.tolerance)
      return refused;
    largest = std::max(largest, off);
    if (slope != 0.0)
      angle += chord.angle();
    at = chord.q;
  }
  return std::sqrt(largest);
}

} // namespace pointmill::gcode
