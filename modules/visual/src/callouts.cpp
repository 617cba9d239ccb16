// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "callouts.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {

constexpr int kRings = 40, kDirections = 16;

bool isFar(const std::vector<Eigen::Vector2f>& others,
           const Eigen::Vector2f& at,
           float distance)
{
  return std::all_of(others.begin(), others.end(), [&](const Eigen::Vector2f& other) {
    return (other - at).norm() >= distance;
  });
}

} // namespace

std::vector<Eigen::Vector2f>
placeCallouts(const std::vector<Eigen::Vector2f>& points, const Rect& room, float size)
{
  const float half = 0.6f * size;
  const Eigen::Vector2f low(room.x + half, room.y + half);
  const Eigen::Vector2f high(room.right() - half, room.bottom() - half);
  std::vector<Eigen::Vector2f> badges;
  for (const Eigen::Vector2f& point : points) {
    Eigen::Vector2f best = point.cwiseMax(low).cwiseMin(high);
    bool found = false;
    for (int ring = 2; ring < kRings && !found; ++ring)
      for (int i = 0; i < kDirections && !found; ++i) {
        // From the upper right on.
        const double angle = M_PI / 4 + 2 * M_PI * i / kDirections;
        const Eigen::Vector2f at =
            point + 0.5f * size * static_cast<float>(ring) *
                        Eigen::Vector2f(static_cast<float>(std::cos(angle)),
                                        static_cast<float>(-std::sin(angle)));
        found = (at.array() >= low.array()).all() &&
                (at.array() <= high.array()).all() && isFar(badges, at, 1.15f * size) &&
                isFar(points, at, 0.8f * size);
        if (found)
          best = at;
      }
    badges.push_back(best);
  }
  return badges;
}

} // namespace pointmill::visual
