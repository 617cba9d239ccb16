// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "grid.h"
#include "tool_outline.h"

#include <pointmill/visual/finding_picture.h>

#include <optional>
#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief A vertical plane. `u` runs along it [mm]: X or Y of the part frame where it
/// runs along one of them, else the distance from its origin.
struct SectionPlane {
  Eigen::Vector2d origin; ///< where u = 0
  Eigen::Vector2d along;  ///< of length 1
  std::string axis;       ///< "X", "Y", or "from the place"
  std::string where;      ///< "along X at Y 12.5"

  double u(const Eigen::Vector2d& p) const { return along.dot(p - origin); }
  /// @brief Distance from the plane, to its left positive.
  double off(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d away = p - origin;
    return along.x() * away.y() - along.y() * away.x();
  }
  Eigen::Vector2d xy(double at) const { return origin + at * along; }
};

/// @brief A length that says how bad a finding is.
struct Dimension {
  Eigen::Vector2d from, to; ///< u and z
  double length;            ///< in space; `to - from` may be a hair longer
};

/// @brief A vertical section through the place of a finding: what its close-up shows.
class Section {
public:
  /// @param mark has a place
  Section(const FindingScene& scene,
          const std::optional<Grid>& milled,
          const FindingMark& mark);

  struct Point {
    Eigen::Vector2d at; ///< u and z
    bool inside;        ///< the tool
  };

  const FindingMark& mark() const { return mark_; }
  const SectionPlane& plane() const { return plane_; }
  const std::optional<Tool>& tool() const { return tool_; }
  const std::optional<Eigen::Vector3d>& tip() const { return tip_; }
  const std::optional<Dimension>& dimension() const { return dimension_; }
  /// @brief The finding's place, u and z.
  Eigen::Vector2d place() const { return at(*mark_.place); }
  /// @brief The tool's tip, where there is one, u and z.
  Eigen::Vector2d tipPlace() const { return at(*tip_); }
  /// @brief Width of what is worth showing [mm].
  double width() const { return width_; }
  /// @brief How far below the place it must be seen as well [mm].
  double drop() const { return drop_; }
  static constexpr double kHeightShare =
      2.0 / 3; ///< of its width that is seen at least
  /// @brief How much of the height the place may stand over what is seen below it.
  static constexpr double kDropShare = 0.8;
  /// @brief How far from the plane the points that are shown lie [mm].
  double reach() const { return reach_; }
  /// @brief The part's points within reach and a box of u and z.
  std::vector<Point> points(const Eigen::AlignedBox2d& box) const;
  /// @brief What is left of the stock at u; NaN where nothing is known of it.
  double milledAt(double u) const;
  /// @brief How deep in the tool a place of the plane is; negative outside [mm].
  double toolDepth(double u, double z) const;
  /// @brief What of the tool it is in.
  ToolOutline::Body toolAt(double u, double z) const;
  /// @brief Where the plane is inside the stock; empty where it is nowhere.
  std::optional<Eigen::AlignedBox2d> stock() const;

private:
  Eigen::Vector2d at(const Eigen::Vector3d& p) const
  {
    return {plane_.u(p.head<2>()), p.z()};
  }
  void findTool();
  void measurePart();
  SectionPlane choosePlane() const;
  double relief(const SectionPlane& plane) const;
  double radiusAt(double u) const;
  double around() const;
  void findDimension();
  void chooseWidth();

  const FindingScene& scene_;
  const std::optional<Grid>& milled_;
  const FindingMark& mark_;
  std::optional<Tool> tool_;
  std::optional<ToolOutline> outline_;
  std::optional<Eigen::Vector3d> tip_;
  double spacing_ = 0; ///< of the part's points around the place [mm]
  double width_ = 0, reach_ = 0, drop_ = 0;
  SectionPlane plane_;
  std::optional<Dimension> dimension_;
};

} // namespace pointmill::visual
