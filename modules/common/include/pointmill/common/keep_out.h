// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out_zone.h>
#include <pointmill/common/tool.h>

#include <vector>

namespace pointmill {

/// @brief All places where no tool may be, and how far tools keep away from them [mm].
///
/// What is asked here is about the zones grown by the margin, sideways and upwards.
/// A tool is nowhere wider than higher up and goes up without end, so that the nearest
/// place of a zone's top edge alone decides: at the distance d a tip is clear from
/// `top - profile(d)` upwards, and at any height beyond the tool's radius. Nothing is
/// sampled. Use the profile in loops, it is worked out once.
class KeepOut {
public:
  /// @brief No zones.
  KeepOut() = default;
  /// @throws ParameterError for a zone that is not valid, and a margin that is not in
  /// 0 .. 100
  explicit KeepOut(std::vector<KeepOutZone> zones, double margin = 1.0);

  bool empty() const { return zones_.empty(); }
  const std::vector<KeepOutZone>& zones() const { return zones_; }
  double margin() const { return margin_; }

  /// @name The lowest height at which the tip is clear of every zone; -infinity where
  /// it is at any
  /// @{
  /// @brief At (x, y).
  double lowest(const CutterProfile& cutter, double x, double y) const;
  double lowest(const Tool& tool, double x, double y) const
  {
    return lowest(tool.profile(), x, y);
  }
  /// @brief On the whole of a level move from (ax, ay) to (bx, by).
  double lowestAlong(
      const CutterProfile& cutter, double ax, double ay, double bx, double by) const;
  double lowestAlong(const Tool& tool, double ax, double ay, double bx, double by) const
  {
    return lowestAlong(tool.profile(), ax, ay, bx, by);
  }
  /// @brief Anywhere in the rectangle @p low .. @p high: a rapid whose axes do not
  /// arrive at once may come by each of its places.
  double lowestOver(const CutterProfile& cutter,
                    const Eigen::Vector2d& low,
                    const Eigen::Vector2d& high) const;
  double lowestOver(const Tool& tool,
                    const Eigen::Vector2d& low,
                    const Eigen::Vector2d& high) const
  {
    return lowestOver(tool.profile(), low, high);
  }
  /// @}

  /// @brief Highest top, with the margin, of all zones; -infinity where there is none.
  double highestTop() const;
  /// @brief Of those that come nearer than @p radius to the rectangle @p low .. @p
  /// high, margin counted.
  double highestTop(const Eigen::Vector2d& low,
                    const Eigen::Vector2d& high,
                    double radius) const;

  /// @brief How deep [mm] the tool gets into the zones on a straight move of its tip
  /// from @p a to @p b, see KeepOutZone::depth(); 0 where it is clear.
  double depth(const CutterProfile& cutter,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b) const;
  double
  depth(const Tool& tool, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    return depth(tool.profile(), a, b);
  }
  bool
  enters(const Tool& tool, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    return depth(tool, a, b) > 0;
  }
  /// @brief The same for a tip that may come by any place of the box @p low .. @p high.
  double depthIn(const CutterProfile& cutter,
                 const Eigen::Vector3d& low,
                 const Eigen::Vector3d& high) const;

private:
  /// How far a zone is, grown by the margin.
  double grown(double distance) const { return std::max(0.0, distance - margin_); }
  template <typename Distance>
  double lowestAt(const CutterProfile& cutter, Distance&& distance) const;

  std::vector<KeepOutZone> zones_;
  double margin_ = 1.0;
};

} // namespace pointmill
