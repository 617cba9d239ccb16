// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "klartext_printer.h"

#include "arc_geometry.h"

#include <cmath>

namespace pointmill::gcode {

namespace {

using Eigen::Vector2d;

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr char axis_letters[] = {'X', 'Y', 'Z'};

/// The point next to @p centre, on the grid, from which @p from and @p to are equally
/// far: with an arc round it to an angle nothing is left over that would add up.
Vector2d poleOf(const Vector2d& from, const Vector2d& to, const Vector2d& centre)
{
  const Vector2d chord = to - from;
  const double off =
      (centre - (from + to) / 2).dot(chord) / std::max(1.0, chord.squaredNorm());
  const Vector2d pole = centre - off * chord;
  return {std::round(pole.x()), std::round(pole.y())};
}

double sweepAbout(const Vector2d& pole,
                  const Vector2d& from,
                  const Vector2d& to,
                  bool clockwise)
{
  const Vector2d a = from - pole, b = to - pole;
  double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (clockwise && angle > 0)
    angle -= 360 * degree;
  if (!clockwise && angle < 0)
    angle += 360 * degree;
  return angle;
}

Vector2d turned(const Vector2d& from, const Vector2d& pole, double angle)
{
  const Vector2d a = from - pole;
  const double c = std::cos(angle), s = std::sin(angle);
  return pole + Vector2d(c * a.x() - s * a.y(), s * a.x() + c * a.y());
}

} // namespace

void KlartextPrinter::approached(const MachinePosition& to)
{
  at_ = to;
  arc_end_.reset();
}

bool KlartextPrinter::isStale(int axis) const
{
  return arc_end_ && axis != axesOf(arc_end_->plane).w;
}

/// The block up to the coordinates.
char* KlartextPrinter::line(const MachinePosition& to)
{
  char* p = word(block(), 'L');
  for (int i = 0; i < 3; ++i)
    if (!at_ || isStale(i) || along(to, i) != along(*at_, i))
      p = coordinate(p, axis_letters[i], along(to, i));
  at_ = to;
  arc_end_.reset();
  return p;
}

/// Whether a block would have no coordinate.
bool KlartextPrinter::isAt(const MachinePosition& to) const
{
  return at_ && to == *at_ && !arc_end_;
}

void KlartextPrinter::traverse(const MachinePosition& to)
{
  if (isAt(to))
    return;
  endBlock(word(line(to), "R0 FMAX"));
  feed_ = 0;
}

void KlartextPrinter::straight(const MachinePosition& to, std::int64_t rate)
{
  if (isAt(to))
    return;
  endBlock(feed(line(to), rate));
}

/// Whether the arc before has ended beside its tick.
bool KlartextPrinter::isOff() const
{
  const auto axis = axesOf(arc_end_->plane);
  const Vector2d at(double(along(*at_, axis.u)), double(along(*at_, axis.v)));
  return (arc_end_->at - at).norm() > 0.5;
}

Vector2d KlartextPrinter::start(ArcPlane plane) const
{
  const auto axis = axesOf(plane);
  Vector2d at(double(along(*at_, axis.u)), double(along(*at_, axis.v)));
  if (arc_end_ && arc_end_->plane == plane)
    at = arc_end_->at;
  return at;
}

void KlartextPrinter::arc(const MachineArc& arc, std::int64_t rate)
{
  const auto axis = axesOf(arc.plane);
  const Vector2d centre(double(along(*at_, axis.u) + arc.u),
                        double(along(*at_, axis.v) + arc.v));
  const Vector2d to(double(along(arc.to, axis.u)), double(along(arc.to, axis.v)));
  if (arc_end_ && arc_end_->plane != arc.plane && isOff())
    straight(*at_, rate);
  const Vector2d from = start(arc.plane);
  const Vector2d pole = poleOf(from, to, centre);

  char* p = word(block(), "CC");
  for (int i = 0; i < 3; ++i)
    if (i != axis.w)
      p = coordinate(p,
                     axis_letters[i],
                     static_cast<std::int64_t>(i == axis.u ? pole.x() : pole.y()));
  endBlock(p);

  const DecimalGrid angles(4);
  const auto angle = angles.nearest(sweepAbout(pole, from, to, arc.clockwise) / degree);
  p = angles.write(word(block(), "CP IPA"), angle, style_);
  if (along(arc.to, axis.w) != along(*at_, axis.w))
    p = coordinate(p, axis_letters[axis.w], along(arc.to, axis.w));
  endBlock(feed(word(p, arc.clockwise ? "DR-" : "DR+"), rate));
  at_ = arc.to;
  arc_end_ = ArcEnd{arc.plane, turned(from, pole, angles.value(angle) * degree)};
}

} // namespace pointmill::gcode
