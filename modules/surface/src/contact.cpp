// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/contact.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

Eigen::Vector3d
contactNormal(const Tool& tool, double x, double y, const Contact& contact)
{
  if (!contact.touches() || tool.isFlat())
    return Eigen::Vector3d::UnitZ();
  Eigen::Vector2d inward(x - contact.at.x(), y - contact.at.y());
  const double d = inward.norm(), u = d - (tool.radius() - tool.corner_radius);
  if (u <= 0)
    return Eigen::Vector3d::UnitZ();
  inward *= u / d / tool.corner_radius;
  const double up = std::sqrt(std::max(0.0, 1.0 - inward.squaredNorm()));
  return {inward.x(), inward.y(), up};
}

} // namespace pointmill
