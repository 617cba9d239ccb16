// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "dubins.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using Eigen::Vector2d;

constexpr double kPiece = M_PI / 12; // of an arc

Vector2d leftOf(double heading)
{
  return {-std::sin(heading), std::cos(heading)};
}

/// How far from one heading to another, turning left (+1) or right (-1): 0 .. 2 pi.
double turn(double from, double to, double side)
{
  const double angle = std::fmod(side * (to - from), 2 * M_PI);
  const double positive = angle < 0 ? angle + 2 * M_PI : angle;
  return positive > 2 * M_PI - 1e-9 ? 0 : positive;
}

void addArc(std::vector<Vector2d>& way,
            const Vector2d& centre,
            double radius,
            double heading,
            double side,
            double angle)
{
  const int pieces = static_cast<int>(std::ceil(angle / kPiece));
  for (int i = 1; i <= pieces; ++i) {
    const double h = heading + side * angle * i / pieces;
    way.push_back(centre - side * radius * leftOf(h));
  }
}

} // namespace

std::vector<std::vector<Vector2d>>
turnsBetween(const Pose& from, const Pose& to, double radius)
{
  std::vector<std::pair<double, std::vector<Vector2d>>> ways;
  for (const double first : {1.0, -1.0})
    for (const double last : {1.0, -1.0}) {
      const Vector2d a = from.at + first * radius * leftOf(from.heading);
      const Vector2d b = to.at + last * radius * leftOf(to.heading);
      const Vector2d between = b - a;
      const double length = between.norm();
      double heading = std::atan2(between.y(), between.x());
      double straight = length;
      if (first != last) { // the inner tangent
        if (length < 2 * radius)
          continue;
        straight = std::sqrt(length * length - 4 * radius * radius);
        heading += first * std::atan2(2 * radius, straight);
      }
      else if (length < 1e-9)
        heading = from.heading;
      const double out = turn(from.heading, heading, first);
      const double in = turn(heading, to.heading, last);
      std::vector<Vector2d> way{from.at};
      addArc(way, a, radius, from.heading, first, out);
      if (straight > 1e-9)
        way.push_back(b - last * radius * leftOf(heading));
      addArc(way, b, radius, heading, last, in);
      way.back() = to.at;
      ways.emplace_back(radius * (out + in) + straight, std::move(way));
    }
  std::stable_sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });
  std::vector<std::vector<Vector2d>> sorted;
  for (auto& way : ways)
    sorted.push_back(std::move(way.second));
  return sorted;
}

} // namespace pointmill
