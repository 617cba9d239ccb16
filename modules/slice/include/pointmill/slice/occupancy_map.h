// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/slice/gaps.h>

#include <utility>
#include <vector>

namespace pointmill {

/// @brief The bi-colour map (paper 001): square cells from Gridstart to Gridend, each
/// with the height of its highest point, as an organised cloud of @ref PointCell. The
/// one map answers every level: at level z a cell is red (part) where its height is
/// above z, and yellow (to mill) where it is not.
///
/// A third state that the paper does not know is the gap: a cell inside the part's
/// outline without points. It is a hole in the scan, not air, and carries the height
/// that
/// @ref GapPolicy says.
template <typename PointT>
class OccupancyMap : public Stage<PointT, PointCell> {
public:
  OccupancyMap() : Stage<PointT, PointCell>("OccupancyMap") {}

  /// @brief Edge of a cell [mm].
  void setCellSize(double cell) { cell_size_ = cell; }
  double getCellSize() const { return cell_size_; }
  /// @brief Empty places narrower than twice this [mm] lie between points, not outside
  /// the part; choose at least the spacing of the points. See measureSpacing().
  void setGapReach(double reach) { gap_reach_ = reach; }
  double getGapReach() const { return gap_reach_; }
  /// @brief For all gaps but the through holes.
  void setGapPolicy(GapPolicy policy) { policy_ = policy; }
  GapPolicy getGapPolicy() const { return policy_; }
  /// @brief A place [mm] in each gap that is a hole through the part: these are milled
  /// to the floor. A place in no gap is refused (ParameterError).
  void setThroughHoles(std::vector<Eigen::Vector2d> places)
  {
    through_holes_ = std::move(places);
  }
  const std::vector<Eigen::Vector2d>& getThroughHoles() const { return through_holes_; }

  /// @brief The gaps that the last run found and what became of each, largest first.
  const std::vector<GapRegion>& getGaps() const { return gaps_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("cell_size", cell_size_, "mm", Range{0.01, 50}, "edge of one map cell");
    v("gap_reach", gap_reach_, "mm", Range{0, 100}, "widest void between two points");
  }

protected:
  void checkParameters() const override { validateParameters(*this, this->getName()); }
  void apply(CellCloud& output) override;

private:
  double cell_size_ = 0.5;
  double gap_reach_ = 1.0;
  GapPolicy policy_ = GapPolicy::Bridge;
  std::vector<Eigen::Vector2d> through_holes_;
  std::vector<GapRegion> gaps_;
};

} // namespace pointmill

#include <pointmill/slice/impl/occupancy_map.hpp>

namespace pointmill {
extern template class OccupancyMap<pcl::PointXYZ>;
extern template class OccupancyMap<pcl::PointXYZI>;
extern template class OccupancyMap<pcl::PointXYZRGB>;
extern template class OccupancyMap<pcl::PointXYZRGBA>;
extern template class OccupancyMap<pcl::PointNormal>;
} // namespace pointmill
