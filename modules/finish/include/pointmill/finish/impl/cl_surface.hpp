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
  Raster raster = raster_;
  raster.floor = std::isfinite(floor_) ? floor_ : model->points().min().z();
  if (!polygon_.empty())
    raster.boundary = Boundary(polygon_, overhang_);
  constexpr double kChoice = 0.02; // of the work
  if (choose_) {
    const WorkStep choice({0.0, kChoice});
    raster.angle = rasterAngle(raster, *model);
  }
  const WorkStep rows({kChoice, 1.0});
  RasterPasses found = raster.over(*model);
  output.swap(found.path);
  const auto set = [&](const char* name, double value) {
    this->report_.set(name, value);
  };
  set("cl_points", static_cast<double>(output.size()));
  set("passes", static_cast<double>(found.passes));
  set("step_over_mm", raster.step_over);
  set("angle_deg", raster.angle);
  if (!raster.keep_out.empty())
    set("keep_out_length_mm", found.kept_out);
  if (raster.scallop <= 0)
    return;
  set("inserted_passes", static_cast<double>(found.inserted));
  set("across_passes", static_cast<double>(found.across));
  set("scallop_p95_mm", found.scallop_p95);
  set("scallop_max_mm", found.scallop_max);
  set("scallop_exceeded_mm2", found.left);
}

} // namespace pointmill
