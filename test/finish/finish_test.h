// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/finish/buffer_points.h>
#include <pointmill/finish/cl_surface.h>
#include <pointmill/surface/stock_field.h>
#include <pointmill_test/clouds.h>
#include <pointmill_test/shapes.h>

#include <gtest/gtest.h>

namespace finish_test {

using namespace pointmill;
using namespace pointmill_test;

const std::vector<Tool> kTools{
    Tool::flat(1, 4.0), Tool::ball(2, 3.0), Tool::bull(3, 5.0, 1.0)};

inline CLCloud raster(CLSurface<pcl::PointXYZ>& stage, const Cloud::ConstPtr& cloud)
{
  CLCloud path;
  stage.setInputCloud(cloud);
  stage.filter(path);
  return path;
}

/// How far a ball of radius @p r sinks into the middle of a square of four points
/// @p spacing apart.
inline double sink(double r, double spacing)
{
  return r - std::sqrt(r * r - spacing * spacing / 2);
}

/// The deepest that any point gets into the tool on any chord of the path, by many
/// small steps.
inline double deepest(const CLCloud& path,
                      const Tool& tool,
                      double allowance,
                      const brute::Points& points)
{
  const Tool grown = tool.grown(allowance);
  const Eigen::Vector3d down(0, 0, allowance);
  double worst = 0;
  forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
    const double low = std::min(a.z(), b.z()) - allowance;
    const double length = (b - a).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / 0.01)));
    for (const auto& p : points) {
      // Only what a step may meet at all.
      if (p.z() <= low || std::min(a.x(), b.x()) - p.x() > grown.radius() ||
          p.x() - std::max(a.x(), b.x()) > grown.radius() ||
          std::min(a.y(), b.y()) - p.y() > grown.radius() ||
          p.y() - std::max(a.y(), b.y()) > grown.radius())
        continue;
      worst = std::max(worst, brute::gouge(grown, a - down, b - down, p, steps));
    }
  });
  return worst;
}

} // namespace finish_test
