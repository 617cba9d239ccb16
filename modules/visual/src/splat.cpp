// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "splat.h"

#include <pointmill/common/parallel.h>

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr int kTile = 12;      // px, for the density
constexpr int kFiner = 4;      // splat sizes up to twice the usual
constexpr int kMaxRadius = 14; // px: points further apart stay apart

template <typename Body>
void forEach(const Camera& camera, const Points& points, const Body& body)
{
  for (const auto& p : points) {
    checkInterrupted();
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      body(camera.project(p.x, p.y, p.z));
  }
}

/// How far apart neighbours are in the picture, from the points in each of its tiles.
class Density {
public:
  Density(const Frame& frame, const Camera& camera, const Points& points)
      : columns_(frame.width / kTile + 1), rows_(frame.height / kTile + 1),
        count_(static_cast<std::size_t>(columns_) * rows_, 0)
  {
    forEach(camera, points, [&](const Eigen::Vector3f& p) {
      if (std::uint32_t* count = tile(p))
        ++*count;
    });
    std::size_t all = 0, used = 0;
    for (const std::uint32_t n : count_) {
      all += n;
      used += n > 0;
    }
    if (all > 0)
      apart_ = apart(static_cast<float>(all) / static_cast<float>(used));
  }
  /// On the whole [px].
  float apart() const { return apart_; }
  /// Around a point [px]; at most twice as far as on the whole.
  float apart(const Eigen::Vector3f& p)
  {
    const std::uint32_t* count = tile(p);
    return count ? std::clamp(apart(static_cast<float>(*count)), apart_, 2 * apart_)
                 : apart_;
  }

private:
  static float apart(float in_tile)
  {
    return kTile / std::sqrt(std::max(in_tile, 1.f));
  }
  std::uint32_t* tile(const Eigen::Vector3f& p)
  {
    const int c = static_cast<int>(std::floor(p.x() / kTile));
    const int r = static_cast<int>(std::floor(p.y() / kTile));
    return c < 0 || r < 0 || c >= columns_ || r >= rows_
               ? nullptr
               : &count_[static_cast<std::size_t>(r) * columns_ + c];
  }
  int columns_;
  int rows_;
  std::vector<std::uint32_t> count_;
  float apart_ = 1.f;
};

/// A disc of pixels with weights that fall off towards its rim.
struct Kernel {
  struct Tap {
    int x, y;
    float weight;
  };
  std::vector<Tap> taps;

  explicit Kernel(float radius)
  {
    const int n = std::min(static_cast<int>(std::ceil(radius)), kMaxRadius);
    for (int y = -n; y <= n; ++y)
      for (int x = -n; x <= n; ++x) {
        const float r2 = static_cast<float>(x * x + y * y) / (radius * radius);
        if (r2 <= 1.f)
          taps.push_back({x, y, std::exp(-3.f * r2)});
      }
  }
  template <typename Body>
  void around(const Frame& frame, const Eigen::Vector3f& p, const Body& body) const
  {
    const int px = static_cast<int>(std::floor(p.x()));
    const int py = static_cast<int>(std::floor(p.y()));
    for (const Tap& tap : taps) {
      const int x = px + tap.x, y = py + tap.y;
      if (x >= 0 && y >= 0 && x < frame.width && y < frame.height)
        body(frame.index(x, y), tap.weight);
    }
  }
};

/// Averages depths along rows or columns without crossing a step of more than @p step
/// mm.
void smooth(const Frame& frame,
            const std::vector<float>& in,
            std::vector<float>& out,
            int radius,
            float step,
            bool along_x)
{
  parallelFor(frame.height, 0, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t i = frame.index(x, y);
      out[i] = in[i];
      if (in[i] == Frame::kNothing)
        continue;
      float sum = 0, weight = 0;
      for (int k = -radius; k <= radius; ++k) {
        const int sx = along_x ? x + k : x, sy = along_x ? y : y + k;
        if (sx < 0 || sy < 0 || sx >= frame.width || sy >= frame.height)
          continue;
        const float d = in[frame.index(sx, sy)];
        if (std::abs(d - in[i]) > step) // also where nothing is seen
          continue;
        sum += d - in[i];
        weight += 1;
      }
      out[i] = in[i] + sum / weight;
    }
  });
}

void normals(Frame& frame,
             const Camera& camera,
             const std::vector<float>& depth,
             const std::vector<char>& mine,
             float step)
{
  // Towards the neighbour that lies nearer in depth: not across an edge.
  const auto slope = [&](std::size_t i, float before, float after) {
    const float back = depth[i] - before, ahead = after - depth[i];
    if (std::abs(ahead) <= step && std::abs(back) <= step)
      return 0.5f * (ahead + back);
    const float one = std::abs(ahead) < std::abs(back) ? ahead : back;
    return std::isfinite(one) ? one : 0.f;
  };
  parallelFor(frame.height, 0, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < frame.width; ++x) {
      const std::size_t i = frame.index(x, y);
      if (!mine[i])
        continue;
      const auto at = [&](int dx, int dy) {
        const int sx = x + dx, sy = y + dy;
        return sx < 0 || sy < 0 || sx >= frame.width || sy >= frame.height
                   ? Frame::kNothing
                   : depth[frame.index(sx, sy)];
      };
      const auto scale = static_cast<float>(camera.scale);
      const float dx = slope(i, at(-1, 0), at(1, 0)) * scale;
      const float dy = slope(i, at(0, 1), at(0, -1)) * scale; // y runs down
      frame.normal[i] = Eigen::Vector3f(-dx, -dy, 1.f).normalized();
    }
  });
}

} // namespace

void drawPoints(Frame& frame,
                const Camera& camera,
                const Points& points,
                Surface surface)
{
  Density density(frame, camera, points);
  const float apart = density.apart();
  const float apart_mm = apart / static_cast<float>(camera.scale);
  const float step = 4 * apart_mm; // depths that differ more are two surfaces
  std::vector<Kernel> cover;       // for 1, 1 + 1 / kFiner, ... times that distance
  for (int i = 0; i <= kFiner; ++i)
    cover.emplace_back(std::max((1.f + static_cast<float>(i) / kFiner) * apart, 1.f));
  const Kernel blend(std::max(2.f * apart, 1.5f));

  std::vector<char> mine(frame.depth.size(), 0);
  forEach(camera, points, [&](const Eigen::Vector3f& p) {
    const float wider = density.apart(p) / apart - 1.f;
    cover[std::lround(wider * kFiner)].around(frame, p, [&](std::size_t i, float) {
      if (p.z() <= frame.depth[i])
        return;
      frame.depth[i] = p.z();
      frame.surface[i] = surface;
      mine[i] = 1;
    });
  });
  std::vector<float> sum(frame.depth.size(), 0.f), weight(frame.depth.size(), 0.f);
  forEach(camera, points, [&](const Eigen::Vector3f& p) {
    blend.around(frame, p, [&](std::size_t i, float w) {
      const float behind = frame.depth[i] - p.z();
      if (!mine[i] || behind > step)
        return;
      sum[i] -= w * behind;
      weight[i] += w;
    });
  });
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (mine[i] && weight[i] > 0)
      frame.depth[i] += sum[i] / weight[i];

  const int radius = std::clamp(static_cast<int>(std::lround(1.4f * apart)), 2, 6);
  std::vector<float>& smoothed = weight;
  smooth(frame, frame.depth, sum, radius, step, true);
  smooth(frame, sum, smoothed, radius, step, false);
  normals(frame, camera, smoothed, mine, step);
}

} // namespace pointmill::visual
