// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "path_colours.h"

#include "words.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill::viewer {

namespace {

using visual::Rgb;

// Of Okabe and Ito, as the operations' colours.
constexpr Rgb kMotions[] = {visual::kRapid,        // Rapid
                            visual::hex(0xD55E00), // Plunge
                            visual::hex(0xE69F00), // Ramp
                            visual::hex(0x009E73), // LeadIn
                            visual::hex(0x0072B2), // Cut
                            visual::hex(0xF0E442), // LeadOut
                            visual::hex(0xCC79A7), // Link
                            visual::kFaintInk};    // Retract
constexpr const char* kMotionNames[] = {
    "rapid", "plunge", "ramp", "lead-in", "cut", "lead-out", "link", "retract"};

Rgb turnOf(std::size_t number)
{
  return visual::kOperations[number % visual::kOperationCount];
}

float figureOf(const PointCL& p, PathColouring by)
{
  return by == PathColouring::Feed    ? p.feed
         : by == PathColouring::Level ? static_cast<float>(p.level)
                                      : p.z;
}

} // namespace

PathColours::PathColours(const ViewerScene& scene, PathColouring by)
    : scene_(scene), by_(by)
{
  if (!scene.path || !isGradual())
    return;
  low_ = std::numeric_limits<float>::infinity();
  high_ = -low_;
  for (const PointCL& p : *scene.path) {
    if (isRapid(p))
      continue;
    low_ = std::min(low_, figureOf(p, by));
    high_ = std::max(high_, figureOf(p, by));
  }
}

bool PathColours::isGradual() const
{
  return by_ == PathColouring::Level || by_ == PathColouring::Feed ||
         by_ == PathColouring::Height;
}

float PathColours::shareOf(float value) const
{
  return high_ > low_ ? (value - low_) / (high_ - low_) : 0.5f;
}

Rgb PathColours::of(const PointCL& p, std::size_t operation) const
{
  switch (by_) {
  case PathColouring::Operation:
    return turnOf(static_cast<std::size_t>(scene_.operations[operation].colour));
  case PathColouring::Pass:
    return turnOf(p.label);
  case PathColouring::Motion:
    return kMotions[std::min<std::size_t>(p.motion, std::size(kMotions) - 1)];
  default:
    return scaleColour(shareOf(figureOf(p, by_)));
  }
}

std::string PathColours::title() const
{
  switch (by_) {
  case PathColouring::Operation:
    return "operations";
  case PathColouring::Pass:
    return "passes";
  case PathColouring::Level:
    return "level";
  case PathColouring::Motion:
    return "motion";
  case PathColouring::Feed:
    return "feed, mm/min";
  case PathColouring::Height:
    return "height of the tip, mm";
  }
  return {};
}

std::vector<LegendEntry> PathColours::legend() const
{
  std::vector<LegendEntry> entries;
  switch (by_) {
  case PathColouring::Operation:
    for (const auto& o : scene_.operations)
      entries.push_back({turnOf(static_cast<std::size_t>(o.colour)), o.name});
    break;
  case PathColouring::Pass:
    for (std::size_t i = 0; i < visual::kOperationCount; ++i)
      entries.push_back({turnOf(i), i == 0 ? "in turn" : ""});
    break;
  case PathColouring::Motion:
    for (std::size_t i = 1; i + 1 < std::size(kMotions); ++i)
      entries.push_back({kMotions[i], kMotionNames[i]});
    break;
  default: {
    // Levels count from 1 for people, and there is nothing between two.
    const bool whole = by_ != PathColouring::Height;
    const float first = by_ == PathColouring::Level ? 1.f : 0.f;
    const int steps = by_ == PathColouring::Level
                          ? std::clamp(static_cast<int>(high_ - low_), 1, 4)
                          : 4;
    for (int i = 0; i <= steps; ++i) {
      const float at = static_cast<float>(i) / static_cast<float>(steps);
      const float value = low_ + (high_ - low_) * at;
      const float shown = whole ? std::round(value) : value;
      entries.push_back({scaleColour(shareOf(shown)), numberText(shown + first)});
    }
  }
  }
  return entries;
}

} // namespace pointmill::viewer
