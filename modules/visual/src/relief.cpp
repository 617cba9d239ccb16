// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "relief.h"

#include "cloud_extent.h"
#include "height_field.h"
#include "splat.h"

namespace pointmill::visual {

namespace {

/// Looks straight down on a plan.
Camera cameraOver(const Plan& plan)
{
  Camera camera;
  camera.right = Eigen::Vector3d::UnitX();
  camera.up = Eigen::Vector3d::UnitY();
  camera.eye = Eigen::Vector3d::UnitZ();
  camera.scale = plan.scale * Frame::kSuper;
  camera.centre = {plan.corner.x(), plan.corner.y(), 0.0};
  return camera;
}

} // namespace

Light drawRelief(Canvas& canvas,
                 const Plan& plan,
                 const pcl::PointCloud<pcl::PointXYZ>* points,
                 const Grid* field)
{
  const Camera camera = cameraOver(plan);
  Frame frame(plan.place.width, plan.place.height);
  Light light;
  light.reach =
      0.05 * Eigen::Vector2d(plan.place.width, plan.place.height).norm() / plan.scale;
  if (points) {
    heightRange(*points, light);
    drawPoints(frame, camera, *points, Surface::Scan);
  }
  else if (field) {
    heightRange(field->cells(), light);
    FieldLook look;
    look.top = Surface::Scan;
    drawField(frame, camera, *field, look);
  }
  shade(frame, camera, light).copyTo(canvas, plan.place.x, plan.place.y);
  return light;
}

} // namespace pointmill::visual
