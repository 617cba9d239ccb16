// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_limiter.h"

#include "arc_geometry.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

constexpr double chord_error = 0.001; // mm
constexpr double degree = 3.14159265358979323846 / 180.0;

int pieces(double sweep, double largest)
{
  // An arc of exactly the largest sweep is one piece.
  return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / largest - 1e-9)));
}

/// The sweep of a chord that leaves its arc by chord_error [rad].
double chordSweep(double radius)
{
  return 2 * std::acos(1 - chord_error / std::max(radius, 2 * chord_error));
}

} // namespace

void ArcLimiter::retract()
{
  at_.reset();
  CallAdapter::retract();
}

void ArcLimiter::changeTool(int number)
{
  at_.reset();
  CallAdapter::changeTool(number);
}

void ArcLimiter::approach(const MachinePosition& to)
{
  at_ = to;
  CallAdapter::approach(to);
}

void ArcLimiter::traverse(const MachinePosition& to)
{
  at_ = to;
  CallAdapter::traverse(to);
}

void ArcLimiter::straight(const MachinePosition& to, std::int64_t feed)
{
  at_ = to;
  CallAdapter::straight(to, feed);
}

void ArcLimiter::arc(const MachineArc& arc, std::int64_t feed)
{
  if (!at_)
    throw Error("GCodeWriter: an arc starts nowhere");
  const ArcGeometry geometry(*at_, arc);
  const bool flat =
      along(arc.to, axesOf(arc.plane).w) == along(*at_, axesOf(arc.plane).w);
  const bool taken = flat ? post_.takesArcs(arc.plane) : post_.takesHelices(arc.plane);
  const int n = pieces(geometry.sweep(),
                       taken ? post_.largest_sweep * degree
                             : chordSweep(grid_.value(1) * geometry.radius()));
  for (int i = 1; i <= n; ++i) {
    const auto to = geometry.point(double(i) / n);
    if (to == *at_)
      continue;
    if (taken)
      CallAdapter::arc(geometry.piece(*at_, to), feed);
    else
      CallAdapter::straight(to, feed);
    at_ = to;
  }
}

} // namespace pointmill::gcode
