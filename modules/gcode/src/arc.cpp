// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc.h"

#include <algorithm>
#include <cmath>

namespace pointmill::gcode {

namespace {

const double pi = std::acos(-1.0);

} // namespace

double Arc::startRadius() const
{
  return arm(from).norm();
}

double Arc::endRadius() const
{
  return arm(to).norm();
}

double Arc::sweep() const
{
  const Eigen::Vector2d a = arm(from), b = arm(to);
  // The angle from a to b, counter-clockwise.
  double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (clockwise)
    angle = -angle;
  // As LinuxCNC: an arc that ends where it starts is a full turn, rounding or not.
  return angle < 1e-6 ? angle + 2 * pi : angle;
}

std::size_t Arc::chords(double error) const
{
  const double radius = std::max(startRadius(), endRadius());
  const double step = 2 * std::acos(1 - std::min(1.0, error / radius));
  return static_cast<std::size_t>(std::ceil(sweep() / std::min(step, pi / 4)));
}

Eigen::Vector3d Arc::point(std::size_t i, std::size_t n) const
{
  if (i == n)
    return to;
  const double part = static_cast<double>(i) / static_cast<double>(n);
  const Eigen::Vector2d a = arm(from);
  const double angle = std::atan2(a.y(), a.x()) + (clockwise ? -part : part) * sweep();
  const double radius = startRadius() + part * (endRadius() - startRadius());
  Eigen::Vector3d p;
  p[u] = centre.x() + radius * std::cos(angle);
  p[v] = centre.y() + radius * std::sin(angle);
  p[w] = from[w] + part * (to[w] - from[w]);
  return p;
}

} // namespace pointmill::gcode
