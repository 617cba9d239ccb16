// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "shade.h"

#include <algorithm>
#include <cmath>
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

/// @brief Sets the heights of the first and last colour to those that nearly all points
/// lie between: a stray point must not take the colours.
template <typename Cloud>
void heightRange(const Cloud& cloud, Light& light)
{
  const std::size_t stride = cloud.size() / 100000 + 1;
  std::vector<float> z;
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    if (std::isfinite(cloud[i].z))
      z.push_back(cloud[i].z);
  if (z.empty())
    return;
  std::sort(z.begin(), z.end());
  light.low = z[z.size() / 500];
  light.high = z[z.size() - 1 - z.size() / 500];
}

} // namespace pointmill::visual
