// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/surface_model.h>

namespace pointmill {

Contact SurfaceModel::drop(const Tool& tool, double x, double y) const
{
  return points_->drop(tool, x, y);
}

void SurfaceModel::dropRow(const Tool& tool,
                           const Eigen::Vector2d& from,
                           const Eigen::Vector2d& step,
                           std::size_t count,
                           Contact* contacts) const
{
  points_->dropRow(tool, from, step, count, contacts);
}

} // namespace pointmill
