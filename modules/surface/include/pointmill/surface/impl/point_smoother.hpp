// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parallel.h>
#include <pointmill/surface/point_smoother.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill {

template <typename PointT>
void PointSmoother<PointT>::apply(PointCloud& output)
{
  std::size_t not_finite = 0;
  output.reserve(this->indices_->size());
  for (const auto i : *this->indices_) {
    const PointT& p = (*this->input_)[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      output.push_back(p);
    else
      ++not_finite;
  }
  output.is_dense = true;
  pcl::Indices all(output.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<pcl::index_t>(i);
  const PointIndex points = makePointIndex(output, all, pcl::PointCloud<PointT>());

  // Row by row of the index, so that neighbours are at hand; each row's points are its
  // own, so the threads do not meet.
  std::vector<std::vector<std::size_t>> rows(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < output.size(); ++i)
    rows[static_cast<std::size_t>(points.rowOf(output[i].y))].push_back(i);
  struct Sums {
    std::size_t surface = 0, edge = 0, held = 0;
    double moved2 = 0, variance = 0;
  };
  std::vector<Sums> sums(rows.size());
  const MostMoved most{getFarthest(), std::min(getFarthest(), most_raised_)};
  parallelFor(rows.size(), threads_, {0.0, 1.0}, [&](std::size_t row) {
    Sums& mine = sums[row];
    auto& ids = rows[row];
    std::sort(ids.begin(), ids.end(), [&](std::size_t a, std::size_t b) {
      return output[a].x < output[b].x || (output[a].x == output[b].x && a < b);
    });
    for (const auto i : ids) {
      PointT& p = output[i];
      const Eigen::Vector3d from(p.x, p.y, p.z);
      const Smoothed s = smoothPoint(points, from, noise_, neighbours_, most);
      p.x = static_cast<float>(s.place.x());
      p.y = static_cast<float>(s.place.y());
      p.z = static_cast<float>(s.place.z());
      mine.surface += s.how == Smoothed::How::Surface;
      mine.edge += s.how == Smoothed::How::Edge;
      mine.held += s.held;
      mine.moved2 += (s.place - from).squaredNorm();
      mine.variance += s.variance;
    }
  });
  Sums total;
  for (const auto& s : sums) {
    total.surface += s.surface;
    total.edge += s.edge;
    total.held += s.held;
    total.moved2 += s.moved2;
    total.variance += s.variance;
  }
  const double count = static_cast<double>(output.size());
  this->report_.set("nan_points", static_cast<double>(not_finite));
  this->report_.set("points", count);
  this->report_.set("on_surface", static_cast<double>(total.surface));
  this->report_.set("beside_edges", static_cast<double>(total.edge));
  this->report_.set("kept", count - double(total.surface) - double(total.edge));
  this->report_.set("held", static_cast<double>(total.held));
  this->report_.set("moved_rms_mm", std::sqrt(total.moved2 / count));
  this->report_.set("noise_left_mm", noise_ * std::sqrt(total.variance / count));
}

} // namespace pointmill
