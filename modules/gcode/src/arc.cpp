// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

const double pi = std::acos(-1.0);

/// How far the ends of a half circle may have been rounded apart [mm].
constexpr double rounding = 0.005;

} // namespace

ArcAxes ArcAxes::of(int plane)
{
  switch (plane) {
  case 180:
    return {2, 0, 1};
  case 190:
    return {1, 2, 0};
  default:
    return {0, 1, 2};
  }
}

Arc::Arc(const Eigen::Vector3d& from,
         const Eigen::Vector3d& to,
         const Eigen::Vector2d& centre,
         ArcAxes axes,
         bool clockwise)
    : from_(from), to_(to), centre_(centre), axes_(axes), clockwise_(clockwise)
{
  const Eigen::Vector2d a = Eigen::Vector2d(from[axes.u], from[axes.v]) - centre;
  const Eigen::Vector2d b = Eigen::Vector2d(to[axes.u], to[axes.v]) - centre;
  start_radius_ = a.norm();
  end_radius_ = b.norm();
  start_angle_ = std::atan2(a.y(), a.x());
  // The angle from a to b, counter-clockwise.
  double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (clockwise)
    angle = -angle;
  // As LinuxCNC: an arc that ends where it starts is a full turn, rounding or not.
  sweep_ = angle < 1e-6 ? angle + 2 * pi : angle;
}

Arc Arc::turned(const Eigen::Vector3d& from,
                const Eigen::Vector2d& centre,
                ArcAxes axes,
                double sweep,
                double rise)
{
  Arc arc(from, from, centre, axes, sweep < 0);
  arc.sweep_ = std::abs(sweep);
  const double angle = arc.start_angle_ + sweep;
  arc.to_[axes.u] = centre.x() + arc.start_radius_ * std::cos(angle);
  arc.to_[axes.v] = centre.y() + arc.start_radius_ * std::sin(angle);
  arc.to_[axes.w] += rise;
  return arc;
}

double Arc::length() const
{
  const double way = sweep_ * (start_radius_ + end_radius_) / 2;
  return std::hypot(way, to_[axes_.w] - from_[axes_.w]);
}

std::size_t Arc::chords(double error) const
{
  const double radius = std::max(start_radius_, end_radius_);
  const double step = 2 * std::acos(1 - std::min(1.0, error / radius));
  return static_cast<std::size_t>(std::ceil(sweep_ / std::min(step, pi / 4)));
}

Eigen::Vector3d Arc::point(std::size_t i, std::size_t n) const
{
  if (i == n)
    return to_;
  const double part = static_cast<double>(i) / static_cast<double>(n);
  const double angle = start_angle_ + (clockwise_ ? -part : part) * sweep_;
  const double radius = start_radius_ + part * (end_radius_ - start_radius_);
  Eigen::Vector3d p;
  p[axes_.u] = centre_.x() + radius * std::cos(angle);
  p[axes_.v] = centre_.y() + radius * std::sin(angle);
  p[axes_.w] = from_[axes_.w] + part * (to_[axes_.w] - from_[axes_.w]);
  return p;
}

std::optional<Eigen::Vector2d> centreByRadius(const Eigen::Vector2d& from,
                                              const Eigen::Vector2d& to,
                                              double radius,
                                              bool clockwise)
{
  const Eigen::Vector2d chord = to - from;
  const double half = chord.norm() / 2;
  const double r = std::abs(radius);
  if (half > r + rounding)
    return std::nullopt;
  const double height = std::sqrt(std::max(0.0, r * r - half * half));
  const bool left = clockwise == (radius < 0);
  const Eigen::Vector2d normal(-chord.y(), chord.x());
  return from + chord / 2 + normal * ((left ? height : -height) / (2 * half));
}

} // namespace pointmill::gcode
