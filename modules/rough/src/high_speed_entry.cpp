// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "high_speed_entry.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::optional<std::vector<Vector3d>> helix(const Level& level,
                                           const Vector2d& centre,
                                           double radius,
                                           double side,
                                           const Descent& descent)
{
  constexpr int kPieces = 36; // of a turn
  const auto at = [&](int piece, double z) {
    const double angle = side * 2 * M_PI * piece / kPieces;
    return Vector3d(centre.x() + radius * std::cos(angle),
                    centre.y() + radius * std::sin(angle),
                    z);
  };
  for (int i = 0; i < kPieces; ++i)
    if (!level.isFree(at(i, 0).head<2>(), at(i + 1, 0).head<2>()))
      return {};
  const double piece = 2 * radius * std::sin(M_PI / kPieces);
  const double height = std::max(0.0, descent.top - level.z());
  const int pieces = std::max(1, int(std::ceil(height / (piece * descent.slope))));
  std::vector<Vector3d> way;
  for (int i = 0; i < pieces; ++i)
    way.push_back(at(i, level.z() + height * (pieces - i) / pieces));
  for (int i = 0; i <= kPieces; ++i)
    way.push_back(at(pieces + i, level.z()));
  return way;
}

std::vector<Vector3d>
rampForthAndBack(const std::vector<Vector2d>& track, double z, const Descent& descent)
{
  const auto size = static_cast<int>(track.size());
  double height = std::max(0.0, descent.top - z);
  std::vector<Vector3d> way{{track[0].x(), track[0].y(), z + height}};
  int at = 0, step = 1;
  // Down to the level, on to that end, and back over all of it.
  const auto go = [&] {
    if (at + step < 0 || at + step >= size)
      step = -step;
    const Vector2d &a = track[at], &b = track[at + step];
    const double length = (b - a).norm(), down = length * descent.slope;
    if (height > 0 && height < down) {
      const Vector2d middle = a + (b - a) * (height / down);
      way.emplace_back(middle.x(), middle.y(), z);
    }
    height = std::max(0.0, height - down);
    way.emplace_back(b.x(), b.y(), z + height);
    at += step;
  };
  while (height > 0)
    go();
  while (at + step >= 0 && at + step < size)
    go();
  for (int i = 1; i < size; ++i)
    go();
  return way;
}

} // namespace pointmill
