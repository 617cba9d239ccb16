// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "camera.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {

Camera lookFrom(double turn_deg, double tilt_deg)
{
  const double turn = turn_deg * M_PI / 180, tilt = tilt_deg * M_PI / 180;
  Camera camera;
  camera.eye = {-std::sin(turn) * std::cos(tilt),
                -std::cos(turn) * std::cos(tilt),
                std::sin(tilt)};
  camera.right = {std::cos(turn), -std::sin(turn), 0.0};
  camera.up = camera.eye.cross(camera.right);
  return camera;
}

} // namespace

Camera
fitCamera(const std::vector<Eigen::AlignedBox3d>& boxes, double width, double height)
{
  Eigen::AlignedBox3d all;
  for (const auto& box : boxes)
    all.extend(box);
  Camera best;
  double best_score = -1;
  for (double turn = 20; turn <= 60; turn += 5)
    for (double tilt = 28; tilt <= 50; tilt += 2) {
      Camera camera = lookFrom(turn, tilt);
      Eigen::AlignedBox2d seen;
      for (const auto& box : boxes)
        for (int i = 0; i < 8; ++i) {
          const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(i);
          const Eigen::Vector3d p = box.corner(type) - all.center();
          seen.extend(Eigen::Vector2d(p.dot(camera.right), p.dot(camera.up)));
        }
      const Eigen::Vector2d size = seen.sizes().cwiseMax(1e-3);
      camera.scale = std::min(width / size.x(), height / size.y());
      camera.centre = all.center() + camera.right * seen.center().x() +
                      camera.up * seen.center().y();
      camera.middle_x = width / 2;
      camera.middle_y = height / 2;
      const Eigen::Vector3d s = all.sizes();
      const double area = s.y() * s.z() * -camera.eye.x() +
                          s.x() * s.z() * -camera.eye.y() +
                          s.x() * s.y() * camera.eye.z();
      // As large as possible, but the usual view where it hardly matters.
      const double score = (1e-9 + area * camera.scale * camera.scale) *
                           (1 - 0.012 * std::abs(turn - 30)) *
                           (1 - 0.006 * std::abs(tilt - 38));
      if (score > best_score) {
        best_score = score;
        best = camera;
      }
    }
  return best;
}

} // namespace pointmill::visual
