// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "path_builder.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector3d;

double
feedOf(const Cutting& cutting, const Vector3d& from, const Vector3d& to, Motion motion)
{
  double feed = cutting.feed;
  if (motion == Motion::Plunge)
    feed = cutting.plunge_feed;
  else if (motion == Motion::Ramp)
    feed = rampFeed(cutting);
  const double down = from.z() - to.z();
  if (down > 0)
    feed = std::min(feed, cutting.plunge_feed * (to - from).norm() / down);
  return feed;
}

PathBuilder::PathBuilder(const Tool& tool,
                         const Cutting& cutting,
                         StockField* stock,
                         StockField* nominal,
                         CLCloud& path)
    : tool_(tool), cutting_(cutting), stock_(stock), path_(path)
{
  if (nominal)
    meter_.emplace(tool, *nominal);
}

void PathBuilder::add(const Vector3d& to, Motion motion, const PointCL& like, bool air)
{
  PointCL p = like;
  p.x = static_cast<float>(to.x());
  p.y = static_cast<float>(to.y());
  p.z = static_cast<float>(to.z());
  p.setMotion(motion);
  p.feed = 0.f;
  if (!path_.empty()) {
    const Vector3d from = at(), there = position(p);
    if (from == there)
      return;
    if (!isRapid(motion))
      p.feed = static_cast<float>(feed(from, there, motion, air));
    else if (meter_)
      meter_->lift();
  }
  path_.push_back(p);
}

double
PathBuilder::feed(const Vector3d& from, const Vector3d& to, Motion motion, bool air)
{
  double feed = air ? cutting_.feed : feedOf(cutting_, from, to, motion);
  if (stock_)
    stock_->cut(tool_, from, to);
  if (!meter_)
    return feed;
  const double before = meter_->figures().volume;
  const double section = meter_->cut(from, to, motion);
  if (motion == Motion::Link)
    link_volume_ += meter_->figures().volume - before;
  // Slower where the tool takes more than it should.
  const double most = kMostSection * tool_.endDiameter() * tool_.endDiameter();
  const bool sideways = (to - from).head<2>().norm() > (to - from).norm() / 2;
  if (sideways && section > most)
    feed *= std::max(kSlowest, most / section);
  return feed;
}

} // namespace pointmill
