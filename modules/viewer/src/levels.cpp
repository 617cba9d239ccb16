// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pointmill::viewer {

namespace {

constexpr int kLevelsOfAMap = 20;
/// Levels that lie nearer are one [mm].
constexpr double kSameLevel = 1e-3;

/// Of the first operation that has several: the lowest cut on each.
std::vector<double> levelsOfPath(const ViewerScene& scene)
{
  for (const auto& operation : scene.operations) {
    std::map<std::uint32_t, double> lowest;
    const std::size_t end =
        std::min(scene.path->size(), operation.first + operation.count);
    for (std::size_t i = operation.first; i < end; ++i) {
      const PointCL& p = (*scene.path)[i];
      if (p.getMotion() != Motion::Cut)
        continue;
      const auto [at, fresh] = lowest.try_emplace(p.level, p.z);
      at->second = std::min<double>(at->second, p.z);
    }
    if (lowest.size() < 2)
      continue;
    std::vector<double> levels;
    for (const auto& [number, z] : lowest)
      levels.push_back(z);
    return levels;
  }
  return {};
}

std::vector<double> levelsOfMap(const CellCloud& map)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PointCell& cell : map)
    if (std::isfinite(cell.z)) {
      low = std::min<double>(low, cell.z);
      high = std::max<double>(high, cell.z);
    }
  std::vector<double> levels;
  for (int i = 1; low < high && i <= kLevelsOfAMap; ++i)
    levels.push_back(high + (low - high) * i / kLevelsOfAMap);
  return levels;
}

} // namespace

std::vector<double> levelsOf(const ViewerScene& scene)
{
  std::vector<double> levels;
  if (scene.path)
    levels = levelsOfPath(scene);
  if (levels.empty() && scene.map)
    levels = levelsOfMap(*scene.map);
  std::sort(levels.rbegin(), levels.rend());
  levels.erase(std::unique(levels.begin(),
                           levels.end(),
                           [](double a, double b) { return a - b < kSameLevel; }),
               levels.end());
  return levels;
}

} // namespace pointmill::viewer
