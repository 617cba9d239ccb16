// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>
#include <pointmill/viewer/viewer_scene.h>
#include <pointmill/visual/colour.h>

#include <string>
#include <vector>

namespace pointmill::viewer {

/// @brief Whether the tool arrives in the air, at the machine's own speed.
inline bool isRapid(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

inline bool same(const visual::Rgb& a, const visual::Rgb& b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

/// @brief What a legend says of one colour, or of a scale's end.
struct LegendEntry {
  visual::Rgb colour;
  std::string text;
};

/// @brief The colour of each CL point by one of its figures, and what it means.
class PathColours {
public:
  PathColours(const ViewerScene& scene, PathColouring by);

  visual::Rgb of(const PointCL& p, std::size_t operation) const;
  /// @brief Whether the colours run into each other, as those of a height do.
  bool isGradual() const;
  /// @brief Title of the legend: "feed, mm/min".
  std::string title() const;
  /// @brief Of a scale that runs from the first to the last where isGradual().
  std::vector<LegendEntry> legend() const;

private:
  float shareOf(float value) const;

  const ViewerScene& scene_;
  PathColouring by_;
  float low_ = 0, high_ = 1; // of what is shown by a scale
};

} // namespace pointmill::viewer
