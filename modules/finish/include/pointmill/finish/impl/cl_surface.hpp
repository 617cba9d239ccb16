// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/finish/cl_surface.h>

namespace pointmill {

template <typename PointT>
void CLSurface<PointT>::apply(CLCloud& output)
{
  auto model = model_;
  if (model && this->indices_->size() != this->input_->size())
    throw ParameterError("CLSurface: with a model of its own it takes no indices");
  if (!model)
    model = std::make_shared<SurfaceModel>(std::make_shared<PointIndex>(makePointIndex(
        *this->input_, *this->indices_, pcl::PointCloud<pcl::PointXYZ>())));
  const double floor = std::isfinite(floor_) ? floor_ : model->points().min().z();
  output = Raster{tool_,
                  step_over_,
                  forward_step_,
                  allowance_,
                  floor,
                  min_slope_,
                  direction_,
                  threads_}
               .over(*model);
  this->report_.set("cl_points", static_cast<double>(output.size()));
  this->report_.set("passes", output.empty() ? 0.0 : output.back().label + 1.0);
  this->report_.set("step_over_mm", step_over_);
}

} // namespace pointmill
