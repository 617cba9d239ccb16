// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "shade.h"

#include <pointmill/common/parallel.h>

#include <array>
#include <cmath>

namespace pointmill::visual {

namespace {

constexpr int kRays = 4;  // per pixel; neighbours of a picture's pixel look elsewhere
constexpr int kSteps = 4; // per ray

class Shader {
public:
  Shader(const Frame& frame, const Camera& camera, const Light& light)
      : frame_(frame), camera_(camera), light_(light)
  {
    const Eigen::Vector3d key = {-0.65, -0.22, 1.0}; // part frame, towards the lamp
    key_ = camera.toView(key.normalized());
    fill_ = camera.toView(Eigen::Vector3d(0.2, -1.0, 0.35).normalized());
    half_ = (key_ + Eigen::Vector3f::UnitZ()).normalized();
    up_ = camera.toView(Eigen::Vector3d::UnitZ());
    // Rays of the kSuper x kSuper pixels that are averaged fill the circle evenly.
    constexpr int cells = Frame::kSuper * Frame::kSuper;
    const auto scale = static_cast<float>(camera.scale);
    const auto reach = static_cast<float>(light.reach);
    for (int i = 0; i < cells; ++i)
      for (int k = 0; k < kRays; ++k) {
        const double angle = 2 * M_PI * (k + static_cast<double>(i) / cells) / kRays;
        const auto cosine = static_cast<float>(std::cos(angle));
        const auto sine = static_cast<float>(std::sin(angle));
        for (int s = 1; s <= kSteps; ++s) {
          const float away =
              reach * scale * static_cast<float>(s * s) / (kSteps * kSteps);
          const int dx = static_cast<int>(std::lround(cosine * away));
          const int dy = static_cast<int>(std::lround(sine * away));
          rays_[i][k][s - 1] = {
              dx, dy, static_cast<float>(dx) / scale, static_cast<float>(-dy) / scale};
        }
      }
  }

  Rgb pixel(int x, int y) const
  {
    const std::size_t i = frame_.index(x, y);
    const Surface what = frame_.surface[i];
    Eigen::Vector3f n = frame_.normal[i].normalized();
    if (n.z() < 0) // a blended normal that turned away
      n.z() = 0;
    const float open = openness(x, y, n);
    const float lit = 0.30f + 0.52f * std::max(0.f, n.dot(key_)) +
                      0.10f * std::max(0.f, n.dot(fill_)) +
                      0.13f * (0.5f + 0.5f * n.dot(up_));
    const float shine = std::pow(std::max(0.f, n.dot(half_)), 28.f);
    const float edge = edgeStrength(x, y);
    switch (what) {
    case Surface::Machined:
      return finish(kMachined, lit * 1.03f, 0.20f * shine, open, 0.50f * edge);
    case Surface::RawStock:
      return finish(kRawStock, lit, 0.05f * shine, open, 0.45f * edge);
    case Surface::Faint:
      return finish(
          hex(0xE9EDF1), 0.35f + 0.65f * lit, 0, 0.3f + 0.7f * open, 0.2f * edge);
    case Surface::Gap: {
      const bool stripe = (x + y) / (2 * Frame::kSuper) % 3 == 0;
      const Rgb base = stripe ? mix(kGap, hex(0xFFFFFF), 0.45f) : kGap;
      return finish(base, 0.25f + 0.75f * lit, 0, 0.5f + 0.5f * open, 0);
    }
    default:
      return finish(heightColour(relativeHeight(x, y)), lit * 1.1f - 0.02f, 0, open, 0);
    }
  }

  bool seen(int x, int y) const
  {
    return frame_.surface[frame_.index(x, y)] != Surface::None;
  }

private:
  /// Where a ray looks, from its pixel.
  struct Look {
    int dx, dy; ///< px
    float x, y; ///< in view axes [mm]
  };

  static Rgb finish(const Rgb& base, float lit, float shine, float open, float edge)
  {
    // Shadows turn cool rather than black.
    const Rgb dark = {0.78f, 0.86f, 1.f};
    const float shadow = 1.f - open;
    const float f = lit * open;
    const Rgb tint = mix({1, 1, 1}, dark, 0.5f * shadow);
    const Rgb c{base.r * tint.r * f + shine * open,
                base.g * tint.g * f + shine * open,
                base.b * tint.b * f + shine * open};
    return mix(c, c * 0.35f, edge);
  }

  float relativeHeight(int x, int y) const
  {
    const double z =
        camera_.heightAt(x + 0.5, y + 0.5, frame_.depth[frame_.index(x, y)]);
    return static_cast<float>((z - light_.low) /
                              std::max(light_.high - light_.low, 1e-9));
  }

  /// 1 where nothing stands around, less in corners: how high the horizon rises.
  float openness(int x, int y, const Eigen::Vector3f& n) const
  {
    const float d = frame_.depth[frame_.index(x, y)];
    const auto reach = static_cast<float>(light_.reach);
    const int cell = y % Frame::kSuper * Frame::kSuper + x % Frame::kSuper;
    float hidden = 0;
    for (const auto& ray : rays_[cell]) {
      float horizon = 0;
      for (const Look& look : ray) {
        const int sx = x + look.dx, sy = y + look.dy;
        if (sx < 0 || sy < 0 || sx >= frame_.width || sy >= frame_.height)
          continue;
        const float other = frame_.depth[frame_.index(sx, sy)];
        if (other == Frame::kNothing)
          continue;
        const Eigen::Vector3f to(look.x, look.y, other - d);
        const float rise = to.dot(n);
        if (rise <= 0) // below the horizon
          continue;
        const float length = to.norm();
        if (length < 1e-6f || length > 2 * reach)
          continue;
        const float fade = 1 - 0.5f * length / reach;
        horizon = std::max(horizon, (rise / length - 0.12f) * fade);
      }
      hidden += horizon;
    }
    return std::clamp(1.f - 1.15f * hidden / kRays, 0.25f, 1.f);
  }

  /// How much depth bends at a pixel: outlines and sharp edges, in 0 .. 1.
  float edgeStrength(int x, int y) const
  {
    if (x == 0 || y == 0 || x + 1 == frame_.width || y + 1 == frame_.height)
      return 0;
    const std::size_t i = frame_.index(x, y);
    const float* d = frame_.depth.data();
    const std::size_t w = frame_.width;
    const float across = d[i - 1] + d[i + 1] - 2 * d[i];
    const float along = d[i - w] + d[i + w] - 2 * d[i];
    // Only where something lies behind: the nearer side draws the outline.
    const float bend = -std::min(across, along) * static_cast<float>(camera_.scale);
    return std::isfinite(bend) ? std::clamp((bend - 3.f) / 6.f, 0.f, 1.f) : 1.f;
  }

  const Frame& frame_;
  const Camera& camera_;
  const Light& light_;
  Eigen::Vector3f key_, fill_, half_, up_;
  using Ray = std::array<Look, kSteps>;
  std::array<std::array<Ray, kRays>, Frame::kSuper * Frame::kSuper> rays_;
};

} // namespace

Raster shade(const Frame& frame, const Camera& camera, const Light& light)
{
  Raster raster;
  raster.width = frame.width;
  raster.height = frame.height;
  raster.pixels.assign(frame.depth.size(), kCard);
  const Shader shader(frame, camera, light);
  parallelFor(frame.height, 0, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < frame.width; ++x)
      if (shader.seen(x, y))
        raster.pixels[frame.index(x, y)] = shader.pixel(x, y);
  });
  return raster;
}

} // namespace pointmill::visual
