// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>
#include <pointmill/finish/cl_surface.h>

#include <algorithm>
#include <vector>

namespace pointmill {
namespace {

/// `count` places that cover [low, high] evenly, at most `step` apart.
struct Places {
  double low, step;
  std::size_t count;
  Places(double from, double to, double most)
      : low(from), step(0),
        count(static_cast<std::size_t>(std::ceil((to - from) / most)) + 1)
  {
    if (count > 1)
      step = (to - from) / static_cast<double>(count - 1);
  }
  double operator[](std::size_t i) const { return low + static_cast<double>(i) * step; }
};

/// The stretches of a pass along which it is steeper than `slope`, with a point more at
/// both ends.
std::vector<CLCloud> steepParts(const CLCloud& pass, double slope)
{
  const std::size_t n = pass.size();
  std::vector<unsigned char> keep(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const double run = std::hypot(pass[i].x - pass[i - 1].x, pass[i].y - pass[i - 1].y);
    if (std::abs(pass[i].z - pass[i - 1].z) <= slope * run)
      continue;
    for (std::size_t k = i >= 2 ? i - 2 : 0; k <= std::min(n - 1, i + 1); ++k)
      keep[k] = 1;
  }
  std::vector<CLCloud> parts;
  for (std::size_t i = 0; i < n; ++i) {
    if (!keep[i])
      continue;
    if (i == 0 || !keep[i - 1])
      parts.emplace_back();
    parts.back().push_back(pass[i]);
  }
  return parts;
}

} // namespace

CLCloud Raster::over(const SurfaceModel& surface) const
{
  const Tool grown = tool.grown(allowance);
  const bool along_x = direction == RasterDirection::AlongX;
  const double reach = grown.radius();
  const Eigen::Vector3d low = surface.points().min(), high = surface.points().max();
  const Places lines = along_x ? Places(low.y(), high.y(), step_over)
                               : Places(low.x(), high.x(), step_over);
  const Places steps = along_x
                           ? Places(low.x() - reach, high.x() + reach, forward_step)
                           : Places(low.y() - reach, high.y() + reach, forward_step);

  std::vector<std::vector<CLCloud>> passes(lines.count);
  parallelFor(lines.count, threads, [&](std::size_t line) {
    auto& mine = passes[line];
    bool open = false;
    for (std::size_t i = 0; i < steps.count; ++i) {
      const double along = steps[line % 2 ? steps.count - 1 - i : i];
      const double x = along_x ? along : lines[line], y = along_x ? lines[line] : along;
      const Contact contact = surface.drop(grown, x, y);
      if (!contact.touches()) {
        open = false;
        continue;
      }
      if (!open) {
        mine.emplace_back();
        open = true;
      }
      PointCL p(x, y, std::max(contact.tip + allowance, floor));
      const Eigen::Vector3d n = contactNormal(grown, x, y, contact);
      p.normal_x = static_cast<float>(n.x());
      p.normal_y = static_cast<float>(n.y());
      p.normal_z = static_cast<float>(n.z());
      mine.back().push_back(p);
    }
    if (min_slope > 0) {
      std::vector<CLCloud> steep;
      for (const auto& pass : mine)
        for (auto& part : steepParts(pass, std::tan(min_slope * M_PI / 180)))
          steep.push_back(std::move(part));
      mine = std::move(steep);
    }
  });

  CLCloud output;
  std::uint32_t label = 0;
  for (auto& line : passes)
    for (auto& pass : line) {
      for (auto& p : pass)
        p.label = label;
      ++label;
      output += pass;
    }
  return output;
}

template class CLSurface<pcl::PointXYZ>;
template class CLSurface<pcl::PointXYZI>;
template class CLSurface<pcl::PointXYZRGB>;
template class CLSurface<pcl::PointXYZRGBA>;
template class CLSurface<pcl::PointNormal>;

} // namespace pointmill
