// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parallel.h>
#include <pointmill/finish/buffer_points.h>

#include <algorithm>
#include <vector>

namespace pointmill {

template <typename PointT>
void BufferPoints<PointT>::apply(CLCloud& output)
{
  auto model = model_;
  if (!model) {
    pcl::Indices all(surface_->size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<pcl::index_t>(i);
    model = std::make_shared<SurfaceModel>(std::make_shared<PointIndex>(
        makePointIndex(*surface_, all, pcl::PointCloud<pcl::PointXYZ>())));
  }
  const double floor = std::isfinite(floor_) ? floor_ : model->points().min().z();

  // Passes, as ranges of the indices.
  std::vector<std::size_t> begin;
  const auto& ids = *this->indices_;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const PointCL& p = (*this->input_)[ids[i]];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw DataError("BufferPoints: CL point " + std::to_string(ids[i]) +
                      " is not finite");
    if (i == 0 || p.label != (*this->input_)[ids[i - 1]].label)
      begin.push_back(i);
  }
  begin.push_back(ids.size());

  struct Refined {
    CLCloud path;
    std::size_t leaps = 0, raised = 0;
  };
  std::vector<Refined> passes(begin.size() - 1);
  parallelFor(passes.size(), threads_, {0.0, 1.0}, [&](std::size_t k) {
    ChordRefiner refiner(*model, tool_, allowance_, floor, band_, shortest_);
    Refined& mine = passes[k];
    std::vector<CurvePoint> chord;
    Eigen::Vector3d last;
    for (std::size_t i = begin[k]; i < begin[k + 1]; ++i) {
      checkInterrupted(); // all may be one pass
      const PointCL& p = (*this->input_)[ids[i]];
      CurvePoint at{{p.x, p.y, p.z}, {p.normal_x, p.normal_y, p.normal_z}};
      const double lowest = refiner.rest(at.tip.x(), at.tip.y()).tip;
      if (at.tip.z() < lowest - 1e-5) { // float32 rounds by less
        at.tip.z() = lowest;
        ++mine.raised;
      }
      chord.clear();
      if (i == begin[k])
        chord.push_back(at);
      else
        refiner.refine(last, at, chord);
      for (const auto& c : chord) {
        PointCL q = p;
        q.x = static_cast<float>(c.tip.x());
        q.y = static_cast<float>(c.tip.y());
        q.z = static_cast<float>(c.tip.z());
        q.normal_x = static_cast<float>(c.normal.x());
        q.normal_y = static_cast<float>(c.normal.y());
        q.normal_z = static_cast<float>(c.normal.z());
        mine.path.push_back(q);
      }
      last = at.tip;
    }
    mine.leaps = refiner.leaps();
  });

  std::size_t leaps = 0, raised = 0;
  for (const auto& pass : passes) {
    output += pass.path;
    leaps += pass.leaps;
    raised += pass.raised;
  }
  this->report_.set("cl_points_in", static_cast<double>(ids.size()));
  this->report_.set("cl_points", static_cast<double>(output.size()));
  this->report_.set("leaps", static_cast<double>(leaps));
  this->report_.set("raised_points", static_cast<double>(raised));
}

} // namespace pointmill
