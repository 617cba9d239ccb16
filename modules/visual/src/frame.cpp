// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "frame.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

Frame::Frame(int w, int h)
    : width(w * kSuper), height(h * kSuper),
      depth(static_cast<std::size_t>(width) * height, kNothing),
      normal(depth.size(), Eigen::Vector3f::UnitZ()),
      surface(depth.size(), Surface::None)
{
}

void Frame::triangle(const Vertex& a, const Vertex& b, const Vertex& c, Surface what)
{
  const float ax = a.at.x(), ay = a.at.y(), bx = b.at.x(), by = b.at.y();
  const float cx = c.at.x(), cy = c.at.y();
  const float area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (!(std::abs(area) > 1e-9f)) // seen edge-on, or not a number
    return;
  const float inverse = 1.f / area;
  const int left =
      std::max(0, static_cast<int>(std::ceil(std::min({ax, bx, cx}) - 0.5f)));
  const int right =
      std::min(width - 1, static_cast<int>(std::floor(std::max({ax, bx, cx}) - 0.5f)));
  const int top =
      std::max(0, static_cast<int>(std::ceil(std::min({ay, by, cy}) - 0.5f)));
  const int bottom =
      std::min(height - 1, static_cast<int>(std::floor(std::max({ay, by, cy}) - 0.5f)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const float u = ((px - ax) * (cy - ay) - (cx - ax) * (py - ay)) * inverse;
      const float v = ((bx - ax) * (py - ay) - (px - ax) * (by - ay)) * inverse;
      // A little over the edge, so that neighbours leave no crack.
      if (u < -1e-4f || v < -1e-4f || u + v > 1.0001f)
        continue;
      const float t = 1.f - u - v;
      const float d = t * a.at.z() + u * b.at.z() + v * c.at.z();
      const std::size_t i = index(x, y);
      if (d <= depth[i])
        continue;
      depth[i] = d;
      normal[i] = t * a.normal + u * b.normal + v * c.normal;
      surface[i] = what;
    }
}

void Raster::copyTo(Canvas& canvas, int x0, int y0) const
{
  constexpr int n = Frame::kSuper;
  for (int y = 0; y < height / n; ++y)
    for (int x = 0; x < width / n; ++x) {
      Rgb sum;
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          sum = sum + pixels[static_cast<std::size_t>(y * n + j) * width + x * n + i];
      canvas.set(x0 + x, y0 + y, sum * (1.f / (n * n)));
    }
}

} // namespace pointmill::visual
