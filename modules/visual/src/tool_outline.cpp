// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "tool_outline.h"

#include <cmath>

namespace pointmill::visual {

namespace {

constexpr int kPieces = 2000; ///< of the outline, when its nearest place is looked for

/// The nearest place of the straight line from a to b.
Eigen::Vector2d
nearestOn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? (p - a).dot(along) / length2 : 0.0;
  return a + std::clamp(t, 0.0, 1.0) * along;
}

double depthOver(const ToolOutline& tool,
                 const Eigen::Vector3d& tip,
                 const Eigen::Vector3d& place)
{
  const Eigen::Vector3d away = place - tip;
  return tool.depth(away.head<2>().norm(), away.z());
}

/// The depth of a place in a convex tool that moves straight has one maximum.
Eigen::Vector3d deepestBetween(Eigen::Vector3d a,
                               Eigen::Vector3d b,
                               const ToolOutline& tool,
                               const Eigen::Vector3d& place)
{
  constexpr int enough = 80;
  for (int i = 0; i < enough; ++i) {
    const Eigen::Vector3d c = (2 * a + b) / 3, d = (a + 2 * b) / 3;
    if (depthOver(tool, c, place) < depthOver(tool, d, place))
      a = c;
    else
      b = d;
  }
  return 0.5 * (a + b);
}

} // namespace

ToolOutline::ToolOutline(const Tool& tool) : cutter_(tool.profile())
{
  if (tool.shank_diameter > 0)
    cylinders_.push_back({Body::Shank, tool.shank_diameter / 2, tool.flute_length});
  if (tool.holder_diameter > 0)
    cylinders_.push_back({Body::Holder, tool.holder_diameter / 2, tool.stick_out});
}

ToolOutline::Body ToolOutline::at(double r, double z) const
{
  for (auto c = cylinders_.rbegin(); c != cylinders_.rend(); ++c)
    if (c->depth(r, z) > 0)
      return c->body;
  return cutter_.depth(r, z) > 0 ? Body::Cutter : Body::None;
}

double ToolOutline::depth(double r, double z) const
{
  double deepest = cutter_.depth(r, z);
  for (const Cylinder& c : cylinders_)
    deepest = std::max(deepest, c.depth(r, z));
  return deepest;
}

Eigen::Vector2d ToolOutline::nearest(double r, double z) const
{
  double deepest = cutter_.depth(r, z);
  Eigen::Vector2d best = nearestOnCutter(r, z);
  for (const Cylinder& c : cylinders_)
    if (c.depth(r, z) > deepest) {
      deepest = c.depth(r, z);
      best = c.radius - r < z - c.foot ? Eigen::Vector2d(c.radius, z)
                                       : Eigen::Vector2d(r, c.foot);
    }
  return best;
}

Eigen::Vector2d ToolOutline::nearestOnCutter(double r, double z) const
{
  const Eigen::Vector2d p(r, z);
  const double rim = cutter_.height(cutter_.radius());
  Eigen::Vector2d best = {cutter_.radius(), std::max(z, rim)};
  Eigen::Vector2d last(0, cutter_.height(0));
  for (int i = 1; i <= kPieces; ++i) {
    // Finer towards the side, where a round outline is steep.
    const double share = static_cast<double>(i) / kPieces;
    const double at = cutter_.radius() * std::sin(share * M_PI / 2);
    const Eigen::Vector2d next(at, cutter_.height(std::min(at, cutter_.radius())));
    const Eigen::Vector2d near = nearestOn(last, next, p);
    if ((near - p).squaredNorm() < (best - p).squaredNorm())
      best = near;
    last = next;
  }
  return best;
}

Eigen::Vector3d deepestOn(const std::vector<Eigen::Vector3d>& way,
                          const ToolOutline& tool,
                          const Eigen::Vector3d& place)
{
  Eigen::Vector3d best = way.front();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Eigen::Vector3d at = deepestBetween(way[i - 1], way[i], tool, place);
    if (depthOver(tool, at, place) > depthOver(tool, best, place))
      best = at;
  }
  return best;
}

} // namespace pointmill::visual
