// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/slice/spacing.h>

namespace pointmill {

/// @brief The spacing of the points, place by place, as an organised cloud of cells
/// whose `z` is not a height but SpacingField::spacing [mm]. Cells that the points
/// cover are Occupied; the others, outside and in gaps, are Empty with NaN.
template <typename PointT>
class SpacingMap : public Stage<PointT, PointCell> {
public:
  SpacingMap() : Stage<PointT, PointCell>("SpacingMap") {}

  /// @brief Edge of a cell [mm]; 0: about 50 points in each.
  void setCellSize(double cell) { cell_size_ = cell; }
  double getCellSize() const { return cell_size_; }
  /// @brief Voids of a larger radius [mm] are gaps or outside. What OccupancyMap is
  /// given, so that every place is judged by one of the two; 0: from the points.
  void setGapReach(double reach) { gap_reach_ = reach; }
  double getGapReach() const { return gap_reach_; }

  /// @brief Of the last run.
  const Spacing& getSpacing() const { return spacing_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("cell_size", cell_size_, "mm", Range{0, 50}, "edge of one map cell");
    v("gap_reach", gap_reach_, "mm", Range{0, 100}, "widest void between two points");
  }

protected:
  void checkParameters() const override { validateParameters(*this, this->getName()); }
  void apply(CellCloud& output) override;

private:
  double cell_size_ = 0.0;
  double gap_reach_ = 0.0;
  Spacing spacing_;
};

} // namespace pointmill

#include <pointmill/slice/impl/spacing_map.hpp>

namespace pointmill {
extern template class SpacingMap<pcl::PointXYZ>;
extern template class SpacingMap<pcl::PointXYZI>;
extern template class SpacingMap<pcl::PointXYZRGB>;
extern template class SpacingMap<pcl::PointXYZRGBA>;
extern template class SpacingMap<pcl::PointNormal>;
} // namespace pointmill
