// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/common/point_types.h>

#include <Eigen/Core>

#include <algorithm>

namespace pointmill {

/// Thinner stock than this over an entry or a link is swarf, not material [mm].
constexpr double kNothing = 0.05;
/// Full feed is for cuts of at most this share of the end's diameter squared, slots of
/// the papers' pitch included; beyond it the feed falls in proportion, to a tenth at
/// least.
constexpr double kMostSection = 0.1, kSlowest = 0.1;
/// What a move that is not planned as a cut may take as cross-section, as a share of
/// the end's diameter squared: a skin.
constexpr double kSkin = 0.01;
/// ... and so high, in diameters.
constexpr double kSkinHeight = 0.5;

/// One move of a path: where to, and how.
struct Step {
  Eigen::Vector3d to;
  Motion motion;
};

inline Eigen::Vector3d position(const PointCL& p)
{
  return {p.x, p.y, p.z};
}

inline bool isRapid(Motion motion)
{
  return motion == Motion::Rapid || motion == Motion::Retract;
}

/// The feed of ramps and helices [mm/min].
inline double rampFeed(const Cutting& cutting)
{
  return std::min(cutting.feed, std::max(cutting.plunge_feed, cutting.feed / 2));
}

/// The feed of a move [mm/min] before heavy cuts slow it: never down faster than the
/// plunge feed.
double feedOf(const Cutting& cutting,
              const Eigen::Vector3d& from,
              const Eigen::Vector3d& to,
              Motion motion);

} // namespace pointmill
