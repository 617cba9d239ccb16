// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/contact.h>

#include <cmath>

namespace pointmill {

Eigen::Vector3d
contactNormal(const Tool& tool, double x, double y, const Contact& contact)
{
  if (!contact.touches())
    return Eigen::Vector3d::UnitZ();
  Eigen::Vector2d inward(x - contact.at.x(), y - contact.at.y());
  const double d = inward.norm(), steepness = tool.profile().steepness(d);
  if (steepness <= 0)
    return Eigen::Vector3d::UnitZ();
  inward *= steepness / d;
  return {inward.x(), inward.y(), std::sqrt(1.0 - steepness * steepness)};
}

} // namespace pointmill
