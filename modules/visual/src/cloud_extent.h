// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "ruler.h"
#include "shade.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief Box of the points that have a place; empty where none has.
template <typename Cloud>
Eigen::AlignedBox3d boxOf(const Cloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud)
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      box.extend(Eigen::Vector3d(p.x, p.y, p.z));
  return box;
}

/// @brief Sets the heights of the first and last colour: the least and the largest, but
/// for a few points far beyond all others, which must not take the colours.
template <typename Cloud>
void heightRange(const Cloud& cloud, Light& light)
{
  const std::size_t stride = cloud.size() / 100000 + 1;
  std::vector<float> z;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!std::isfinite(cloud[i].z))
      continue;
    lowest = std::min<double>(lowest, cloud[i].z);
    highest = std::max<double>(highest, cloud[i].z);
    if (i % stride == 0)
      z.push_back(cloud[i].z);
  }
  if (z.empty())
    return;
  std::sort(z.begin(), z.end());
  light.low = z[z.size() / 500];
  light.high = z[z.size() - 1 - z.size() / 500];
  constexpr double far = 0.1; // of the heights of nearly all
  const double most = far * (light.high - light.low);
  light.more_below = light.low - lowest > most;
  light.more_above = highest - light.high > most;
  if (!light.more_below)
    light.low = lowest;
  if (!light.more_above)
    light.high = highest;
}

/// @brief The heights of the first and last colour as legends name them, "-12.5" or
/// "< -12.5" where some are beyond.
inline std::string lowText(const Light& light)
{
  return (light.more_below ? "< " : "") + number(light.low);
}
inline std::string highText(const Light& light)
{
  return (light.more_above ? "> " : "") + number(light.high) + " mm";
}

} // namespace pointmill::visual
