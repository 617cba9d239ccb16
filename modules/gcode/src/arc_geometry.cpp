// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_geometry.h"

#include <cmath>

namespace pointmill::gcode {

namespace {

constexpr double pi = 3.14159265358979323846;

} // namespace

ArcGeometry::ArcGeometry(const MachinePosition& from, const MachineArc& arc)
    : from_(from), arc_(arc), axis_(axesOf(arc.plane)),
      centre_u_(along(from, axis_.u) + arc.u), centre_v_(along(from, axis_.v) + arc.v)
{
  const double au = double(-arc.u), av = double(-arc.v);
  const double bu = double(along(arc.to, axis_.u) - centre_u_);
  const double bv = double(along(arc.to, axis_.v) - centre_v_);
  start_angle_ = std::atan2(av, au);
  end_radius_ = std::hypot(bu, bv);
  sweep_ = std::atan2(au * bv - av * bu, au * bu + av * bv);
  if (arc.clockwise)
    sweep_ = -sweep_;
  if (sweep_ <= 0.0)
    sweep_ += 2 * pi;
  if (arc.clockwise)
    sweep_ = -sweep_;
}

double ArcGeometry::radius() const
{
  return std::hypot(double(arc_.u), double(arc_.v));
}

MachinePosition ArcGeometry::point(double part) const
{
  if (part >= 1.0)
    return arc_.to;
  const double angle = start_angle_ + part * sweep_;
  const double r = radius() + part * (end_radius_ - radius());
  MachinePosition p = from_;
  along(p, axis_.u) = centre_u_ + std::llround(r * std::cos(angle));
  along(p, axis_.v) = centre_v_ + std::llround(r * std::sin(angle));
  const double rise = double(along(arc_.to, axis_.w) - along(from_, axis_.w));
  along(p, axis_.w) += static_cast<std::int64_t>(std::ceil(part * rise));
  return p;
}

MachineArc ArcGeometry::piece(const MachinePosition& from,
                              const MachinePosition& to) const
{
  MachineArc piece = arc_;
  piece.to = to;
  piece.u = centre_u_ - along(from, axis_.u);
  piece.v = centre_v_ - along(from, axis_.v);
  return piece;
}

} // namespace pointmill::gcode
