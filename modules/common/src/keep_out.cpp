// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/keep_out.h>
#include <pointmill/common/parameters.h>

#include <limits>

namespace pointmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

KeepOut::KeepOut(std::vector<KeepOutZone> zones, double margin)
    : zones_(std::move(zones)), margin_(margin)
{
  checkRange("keep-out zones", "margin", margin, "mm", {0, 100});
  for (const auto& zone : zones_)
    zone.validate();
}

template <typename Distance>
double KeepOut::lowestAt(const CutterProfile& cutter, Distance&& distance) const
{
  double tip = -kInfinity;
  for (const auto& zone : zones_) {
    const double top = zone.top() + margin_;
    if (top > tip) // height() is infinite beyond the cutter
      tip = std::max(tip, top - cutter.height(grown(distance(zone))));
  }
  return tip;
}

double KeepOut::lowest(const CutterProfile& cutter, double x, double y) const
{
  return lowestAt(cutter, [&](const KeepOutZone& z) { return z.distance(x, y); });
}

double KeepOut::lowestAlong(
    const CutterProfile& cutter, double ax, double ay, double bx, double by) const
{
  return lowestAt(
      cutter, [&](const KeepOutZone& z) { return z.distanceAlong(ax, ay, bx, by); });
}

double KeepOut::lowestOver(const CutterProfile& cutter,
                           const Eigen::Vector2d& low,
                           const Eigen::Vector2d& high) const
{
  return lowestAt(cutter,
                  [&](const KeepOutZone& z) { return z.distanceOver(low, high); });
}

double KeepOut::highestTop() const
{
  double top = -kInfinity;
  for (const auto& zone : zones_)
    top = std::max(top, zone.top() + margin_);
  return top;
}

double KeepOut::highestTop(const Eigen::Vector2d& low,
                           const Eigen::Vector2d& high,
                           double radius) const
{
  double top = -kInfinity;
  for (const auto& zone : zones_)
    if (zone.top() + margin_ > top && grown(zone.distanceOver(low, high)) <= radius)
      top = zone.top() + margin_;
  return top;
}

double KeepOut::depth(const CutterProfile& cutter,
                      const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b) const
{
  double depth = 0;
  for (const auto& zone : zones_)
    depth = std::max(depth, zone.depth(cutter, a, b, margin_));
  return depth;
}

double KeepOut::depthIn(const CutterProfile& cutter,
                        const Eigen::Vector3d& low,
                        const Eigen::Vector3d& high) const
{
  double depth = 0;
  for (const auto& zone : zones_) {
    const double off = grown(zone.distanceOver(low.head<2>(), high.head<2>()));
    if (off <= cutter.radius())
      depth = std::max(depth, cutter.depth(off, zone.top() + margin_ - low.z()));
  }
  return depth;
}

} // namespace pointmill
