// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parameters.h>
#include <pointmill/surface/patch.h>
#include <pointmill/surface/surface_model.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kPatches = 3; // the contact may move on to a neighbouring patch
constexpr int kSteps = 8;   // of the search on one patch
/// Points may lie further from a wider patch, by this share of its radius: still far
/// less than what the cutter would sink between them.
constexpr double kRoughness = 0.01;
constexpr double kSteepest = 0.05; // least upward part of a normal
/// The contact has settled when it moves by less than this share of the patch; the tip
/// errs by the square of it.
constexpr double kSettled = 1e-4;
constexpr double kOnTheRim = 1e-7; // share of the radius

/// Where @p tool with its axis at @p axis touches the plane through @p q with normal
/// @p m.
Vector3d
touch(const Tool& tool, const Vector2d& axis, const Vector3d& q, const Vector3d& m)
{
  const Vector2d aside = m.head<2>();
  const double sine = aside.norm();
  // A cone's side has one slope; what is steeper touches its shoulder.
  const bool side = tool.isTapered() && sine > std::cos(tool.taper * M_PI / 180);
  const double rounding = side ? tool.shoulder_radius : tool.corner_radius;
  const double straight = side ? tool.radius() - rounding : tool.flatRadius();
  Vector2d at = axis;
  if (sine > 1e-12) // uphill of the axis
    at -= aside * ((straight + rounding * sine) / sine);
  const double z = q.z() - aside.dot(at - q.head<2>()) / m.z();
  return {at.x(), at.y(), z};
}

} // namespace

SurfaceModel::SurfaceModel(std::shared_ptr<const PointIndex> points,
                           const SmoothSurface& smooth)
    : points_(std::move(points)), smooth_(smooth)
{
  checkRange("SurfaceModel", "neighbours", smooth.neighbours, "", {12, 1000});
  checkRange("SurfaceModel", "fidelity", smooth.fidelity, "mm", {1e-9, 100});
}

// The contact is where patch and tool have one normal: from the tool's contact with the
// tangent plane to the patch below it, and again. Whatever place of the patch it ends
// at, the tool cannot be lower than that place lets it.
void SurfaceModel::restOnPatch(const Tool& tool,
                               double x,
                               double y,
                               Contact& contact) const
{
  static thread_local Neighbourhood near;
  const Vector2d axis(x, y);
  Vector3d place = contact.at;
  Vector3d normal = contactNormal(tool, x, y, contact);
  for (int patches = 0; patches < kPatches; ++patches) {
    Patch patch;
    bool fits = false;
    for (const int share : {1, 2}) { // curved ground may need a smaller one
      near.gather(
          *points_, place, static_cast<std::size_t>(smooth_.neighbours / share));
      if (tool.corner_radius <= 0) // the contact of a sharp edge tells no normal
        normal = near.planeNormal();
      fits = patch.fit(near, normal) &&
             patch.residual() <= smooth_.fidelity + kRoughness * near.radius;
      if (fits)
        break;
    }
    if (!fits)
      return;
    Vector2d st(0, 0);
    const double reach = near.radius;
    for (int step = 0; step < kSteps; ++step) {
      const Vector3d m = patch.normalAt(st.x(), st.y());
      if (m.z() < kSteepest)
        return;
      const Vector3d q = patch.at(st.x(), st.y());
      const Vector2d next = patch.project(touch(tool, axis, q, m));
      const double moved = (next - st).norm();
      st = next;
      if (!(st.norm() < reach))
        break;
      if (moved < kSettled * reach)
        break;
    }
    const double away = st.norm();
    if (!(away < 2 * reach))
      return;
    if (away > reach / 2 || !patch.isBetween(near, st.x(), st.y())) {
      // Too near to the border of the patch: another one round this place.
      st *= std::min(1.0, reach / away);
      place = patch.at(st.x(), st.y());
      normal = patch.normalAt(st.x(), st.y());
      continue;
    }
    const Vector3d q = patch.at(st.x(), st.y());
    double d = (q.head<2>() - axis).norm();
    if (d < tool.radius() * (1 + kOnTheRim)) // rounding must not push it off
      d = std::min(d, tool.radius());
    const double tip = q.z() - tool.profile(d);
    if (tip > contact.tip) {
      contact.tip = tip;
      contact.at = q;
    }
    return;
  }
}

Contact SurfaceModel::drop(const Tool& tool, double x, double y) const
{
  Contact contact = points_->drop(tool, x, y);
  if (isSmooth() && contact.touches())
    restOnPatch(tool, x, y, contact);
  return contact;
}

void SurfaceModel::dropRow(const Tool& tool,
                           const Eigen::Vector2d& from,
                           const Eigen::Vector2d& step,
                           std::size_t count,
                           Contact* contacts) const
{
  points_->dropRow(tool, from, step, count, contacts);
  if (!isSmooth())
    return;
  for (std::size_t i = 0; i < count; ++i) {
    if (!contacts[i].touches())
      continue;
    const Eigen::Vector2d at = from + static_cast<double>(i) * step;
    restOnPatch(tool, at.x(), at.y(), contacts[i]);
  }
}

} // namespace pointmill
