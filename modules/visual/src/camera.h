// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace pointmill::visual {

/// @brief Parallel projection of the part frame [mm] to pixels.
struct Camera {
  Eigen::Vector3d right, up, eye; ///< unit axes of the view; `eye` points at the viewer
  Eigen::Vector3d centre;         ///< the point in the middle of the picture
  double scale = 1.0;             ///< px per mm
  double middle_x = 0.0, middle_y = 0.0; ///< px

  /// @brief Pixel x, pixel y (down), and depth [mm], larger towards the viewer.
  Eigen::Vector3f project(double x, double y, double z) const
  {
    const Eigen::Vector3d p = Eigen::Vector3d(x, y, z) - centre;
    return {static_cast<float>(middle_x + scale * p.dot(right)),
            static_cast<float>(middle_y - scale * p.dot(up)),
            static_cast<float>(p.dot(eye))};
  }
  /// @brief Height in the part frame [mm] of what is seen at a pixel.
  double heightAt(double px, double py, double depth) const
  {
    return centre.z() + (px - middle_x) / scale * right.z() +
           (middle_y - py) / scale * up.z() + depth * eye.z();
  }
  /// @brief A direction of the part frame along right, up, eye.
  Eigen::Vector3f toView(const Eigen::Vector3d& v) const
  {
    return Eigen::Vector3d(v.dot(right), v.dot(up), v.dot(eye)).cast<float>();
  }
};

/// @brief Looks at the boxes from the front (-Y), left (-X) and above (+Z), turned and
/// tilted so that they fill @p width x @p height px.
Camera
fitCamera(const std::vector<Eigen::AlignedBox3d>& boxes, double width, double height);

} // namespace pointmill::visual
