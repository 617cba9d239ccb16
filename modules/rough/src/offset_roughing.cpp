// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "offset_rings.h"

#include <pointmill/common/watch.h>
#include <pointmill/rough/offset_roughing.h>

#include <algorithm>
#include <limits>

namespace pointmill {
namespace {

using Eigen::Vector2d;

/// Lines whose ends are no further apart than this many step-overs are one path.
constexpr double kJoin = 2.5;

/// Puts lines into an order in which each begins near to where the last one ends, and
/// joins those that can be.
class Planner {
public:
  Planner(const Level& level, std::vector<OffsetArea> areas, bool inwards)
      : level_(level), areas_(std::move(areas)), children_(areas_.size()),
        inwards_(inwards)
  {
    for (std::size_t i = 0; i < areas_.size(); ++i)
      (areas_[i].parent < 0 ? roots_ : children_[areas_[i].parent])
          .push_back(static_cast<int>(i));
  }

  std::vector<LevelPath> plan()
  {
    millAreas(roots_);
    return std::move(paths_);
  }

private:
  /// The way to the nearest point where the lines of an area may be begun.
  double distanceTo(const OffsetArea& area) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& line : area.lines)
      nearest = std::min(nearest, (line.points[beginningOf(line)] - at_).norm());
    return nearest;
  }

  /// The point to begin at: any of a closed line, the nearer end of an open one.
  std::size_t beginningOf(const IsoLine& line) const
  {
    if (!line.closed)
      return (line.points.back() - at_).squaredNorm() <
                     (line.points.front() - at_).squaredNorm()
                 ? line.points.size() - 1
                 : 0;
    std::size_t best = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
      if ((line.points[i] - at_).squaredNorm() <
          (line.points[best] - at_).squaredNorm())
        best = i;
    return best;
  }

  void millAreas(std::vector<int> areas)
  {
    while (!areas.empty()) {
      const auto nearest =
          std::min_element(areas.begin(), areas.end(), [&](int a, int b) {
            return distanceTo(areas_[a]) < distanceTo(areas_[b]);
          });
      const int next = *nearest;
      areas.erase(nearest);
      if (inwards_)
        millLines(areas_[next]);
      millAreas(children_[next]);
      if (!inwards_)
        millLines(areas_[next]);
    }
  }

  void millLines(OffsetArea& area)
  {
    auto& lines = area.lines;
    while (!lines.empty()) {
      checkInterrupted();
      const auto nearest = std::min_element(
          lines.begin(), lines.end(), [&](const auto& a, const auto& b) {
            return (a.points[beginningOf(a)] - at_).squaredNorm() <
                   (b.points[beginningOf(b)] - at_).squaredNorm();
          });
      mill(*nearest);
      lines.erase(nearest);
    }
  }

  void mill(IsoLine& line)
  {
    auto& points = line.points;
    const std::size_t first = beginningOf(line);
    if (line.closed) {
      std::rotate(points.begin(), points.begin() + first, points.end());
      points.push_back(points.front());
    }
    else if (first > 0)
      std::reverse(points.begin(), points.end());
    points = corners(points);
    if (points.size() < 2)
      return;
    const bool joined = !paths_.empty() &&
                        (points.front() - at_).norm() <= kJoin * level_.stepOver() &&
                        level_.isFree(at_, points.front());
    if (!joined) {
      paths_.emplace_back();
      paths_.back().reversible = false;
    }
    for (const auto& p : points)
      paths_.back().points.push_back({level_.at(p)});
    at_ = points.back();
  }

  const Level& level_;
  std::vector<OffsetArea> areas_;
  std::vector<std::vector<int>> children_;
  std::vector<int> roots_;
  bool inwards_;
  Vector2d at_ = Vector2d::Zero();
  std::vector<LevelPath> paths_;
};

} // namespace

std::vector<LevelPath> OffsetRoughing::clearLevel(const Level& level, Report&) const
{
  const bool walls = hasWalls(level);
  return Planner(level, offsetAreas(level, walls), !walls).plan();
}

} // namespace pointmill
