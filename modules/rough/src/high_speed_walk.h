// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>
#include <pointmill/rough/material.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief Where the tool's axis is and which way it goes.
struct Pose {
  Eigen::Vector2d at{0, 0};
  double heading = 0; ///< from +X anticlockwise [rad]

  Eigen::Vector2d ahead(double length) const;
};

/// @brief What a walk may do [mm].
struct WalkLimits {
  double radius;   ///< of the tool's end
  double width;    ///< largest width of cut: area cut per length
  double step;     ///< length of one move
  double tightest; ///< radius of the tightest turn
  double side;     ///< +1: the material is on the right; -1: on the left
};

/// @brief What a walk tries to keep open, so that it turns along a wall before it runs
/// into it: a turn away from the material that is gentle at first, the tightest one, or
/// none.
enum class WayOut { Gentle, Tight, None };

/// @brief A walk with the material on one side, and what it took.
struct Walk {
  std::vector<Eigen::Vector2d> points;
  double heading = 0; ///< at the last point
  double area = 0;    ///< taken of that which is to be cut [mm2]
  Material::Log log;
};

/// @brief Walks that keep the width of cut at its limit: at every step the tool turns
/// towards the material as far as the limit, the part and the tightest turn allow.
///
/// The width of a straight cut beside a flank is a stable equilibrium of this rule:
/// with the tool's axis at the angle a over the flank, as seen from where the tool's
/// rim leaves it, the width is r (1 - sin(a + heading)), so that a tool that is too far
/// out is headed inwards, and the deviation dies down over about a radius.
class Walker {
public:
  Walker(const Level& level, Material& material, const WalkLimits& limits);

  const WalkLimits& limits() const { return limits_; }
  /// @brief How far the walls are from @p p at least; infinite without walls [mm].
  double roomAt(const Eigen::Vector2d& p) const;

  /// @brief Cuts from @p start on until nothing is cut for a while or there is no way
  /// on. The material is cut; the last move through air is left out.
  /// @param any_heading the first move may turn as it likes
  Walk cutFrom(const Pose& start, bool any_heading, WayOut way_out = WayOut::Gentle);

private:
  struct Turn {
    double angle; ///< away from the material [rad]
    bool possible;
  };
  Pose turned(const Pose& from, double angle) const;
  bool mayGo(const Pose& to, const Eigen::Vector2d& from, WayOut way_out) const;
  bool hasWayOut(const Pose& pose, WayOut kind) const;
  Turn bestTurn(const Pose& pose, double in, double out, WayOut way_out) const;
  Turn
  nearTurn(const Pose& pose, double guess, double in, double out, WayOut way_out) const;

  const Level& level_;
  Material& material_;
  WalkLimits limits_;
  std::size_t most_;        // cells that one move may cut
  std::vector<float> room_; // of nodes, in cells
};

} // namespace pointmill
