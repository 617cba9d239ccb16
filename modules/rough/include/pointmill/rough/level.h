// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/rough/level_map.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace pointmill {

/// @brief One level of a LevelMap, as every strategy sees it: where the tool may be
/// with its tip on the level, and where it must go.
class Level {
public:
  /// @param z height of the tip [mm]
  /// @param step_over distance between neighbouring rows or contours [mm]
  /// @param below what is free at this lower level too is left to that level [mm]
  /// @param regions the map's, or null: all is one
  Level(const LevelMap& map,
        double z,
        double step_over,
        double below = -std::numeric_limits<double>::infinity(),
        const std::vector<int>* regions = nullptr);

  const LevelMap& map() const { return *map_; }
  double z() const { return z_; }
  double stepOver() const { return step_over_; }
  /// @brief The step-over in whole nodes, at least one.
  int stride() const;

  /// @brief Whether the tool may stand at @p n: it leaves the allowance on the part.
  bool isFree(Node n) const { return map_->has(n) && state_[map_->index(n)] & kFree; }
  /// @brief Whether it is free and there is stock to cut under the tool's end.
  bool isNeeded(Node n) const
  {
    return map_->has(n) && state_[map_->index(n)] & kNeeded;
  }
  /// @brief Set for the nodes that are needed.
  std::vector<unsigned char> neededNodes() const;
  /// @brief Whether the straight move from @p a to @p b is proven free.
  bool isFree(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
  {
    return map_->lowestAlong(a, b) <= z_ + kTouch;
  }
  /// @brief Whether it is proven free by the points themselves; slower, but not a cell
  /// off beside walls.
  bool isFreeOfPoints(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
  {
    return map_->lowestAlongPoints(a, b) <= z_ + kTouch;
  }
  /// @brief The map's region that the node is in; 0: far from all stock.
  int region(Node n) const { return regions_ ? (*regions_)[map_->index(n)] : 1; }
  /// @brief Whether any node is needed.
  bool isEmpty() const { return empty_; }

  Eigen::Vector3d at(Node n) const { return {map_->x(n), map_->y(n), z_}; }
  Eigen::Vector3d at(const Eigen::Vector2d& p) const { return {p.x(), p.y(), z_}; }

private:
  static constexpr unsigned char kFree = 1, kNeeded = 2;
  static constexpr double kTouch = 1e-6; // rounding [mm]

  const LevelMap* map_;
  const std::vector<int>* regions_;
  double z_, step_over_;
  bool empty_ = true;
  std::vector<unsigned char> state_;
};

/// @brief A connected path over nodes that the tool clears without leaving the level.
using Chain = std::vector<Node>;

/// @brief A place on a path, and how the tool gets there.
struct PathPoint {
  Eigen::Vector3d at; ///< the tip [mm]
  Motion motion = Motion::Cut;
};

/// @brief What the tool does in one go: proven free of the part over its whole length.
struct LevelPath {
  std::vector<PathPoint> points;
  bool reversible = true; ///< may as well be milled from its end
};

/// @brief The path along @p chain, with points at its corners only.
LevelPath pathAlong(const Level& level, const Chain& chain);

} // namespace pointmill
