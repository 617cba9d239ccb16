// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "aim.h"

#include <vtkCamera.h>

namespace pointmill::viewer {

namespace {

struct Direction {
  Eigen::Vector3d eye, up;
};

Direction directionOf(ViewedFrom from)
{
  switch (from) {
  case ViewedFrom::Top:
    return {{0, 0, 1}, {0, 1, 0}};
  case ViewedFrom::Front:
    return {{0, -1, 0}, {0, 0, 1}};
  case ViewedFrom::Back:
    return {{0, 1, 0}, {0, 0, 1}};
  case ViewedFrom::Left:
    return {{-1, 0, 0}, {0, 0, 1}};
  case ViewedFrom::Right:
    return {{1, 0, 0}, {0, 0, 1}};
  case ViewedFrom::Iso:
    break;
  }
  return {{-0.55, -1.0, 0.85}, {0, 0, 1}};
}

/// Brings the box into the room that texts leave.
void fill(const Eigen::AlignedBox3d& box, bool beside_texts, vtkRenderer* renderer)
{
  const Eigen::Vector3d lo = box.min(), hi = box.max();
  renderer->ResetCamera(lo.x(), hi.x(), lo.y(), hi.y(), lo.z(), hi.z());
  // The legend is on the right, figures are at the foot: what is free, from -1 to 1.
  const Eigen::AlignedBox2d room(
      Eigen::Vector2d(-0.94, beside_texts ? -0.78 : -0.94),
      Eigen::Vector2d(beside_texts ? 0.72 : 0.94, beside_texts ? 0.88 : 0.94));
  vtkCamera* camera = renderer->GetActiveCamera();
  constexpr int enough = 3; // perspective makes it no simple proportion
  for (int i = 0; i < enough; ++i) {
    Eigen::AlignedBox2d seen;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d p =
          box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      Eigen::Vector3d view = p;
      renderer->WorldToView(view.x(), view.y(), view.z());
      seen.extend(view.head<2>());
    }
    camera->Zoom((room.sizes().array() / seen.sizes().array()).minCoeff());
    // The window's middle is given in its halves.
    const Eigen::Vector2d off = seen.center() - room.center();
    double now[2];
    camera->GetWindowCenter(now);
    camera->SetWindowCenter(now[0] + off.x(), now[1] + off.y());
  }
}

} // namespace

void lookFrom(ViewedFrom from,
              const Eigen::AlignedBox3d& box,
              bool beside_texts,
              vtkRenderer* renderer)
{
  const Direction d = directionOf(from);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(d.eye.x(), d.eye.y(), d.eye.z());
  camera->SetViewUp(d.up.x(), d.up.y(), d.up.z());
  camera->SetViewAngle(25);
  camera->SetWindowCenter(0, 0);
  camera->SetParallelProjection(from != ViewedFrom::Iso); // sizes are comparable
  if (box.isEmpty())
    renderer->ResetCamera();
  else
    fill(box, beside_texts, renderer);
  renderer->ResetCameraClippingRange();
}

void lookAt(const Eigen::Vector3d& place, double distance, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d back = -Eigen::Vector3d(camera->GetDirectionOfProjection());
  const Eigen::Vector3d eye = place + distance * back;
  camera->SetFocalPoint(place.data());
  camera->SetPosition(eye.data());
  camera->SetWindowCenter(0, 0);
  renderer->ResetCameraClippingRange();
}

} // namespace pointmill::viewer
