// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/common/stock.h>
#include <pointmill/finish/raster.h>

#include <memory>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Raster rows over the cutter-location surface: the tip's height is
/// `max over the points under the cutter of p.z - profile(|p - c|)` (paper 000, 3.3.2,
/// corrected), every point counted. One pass (`label`) for every stretch of a row with
/// points under the cutter; `normal` is the surface normal at the contact. Where the
/// ground falls or curves across the rows so that scallops would be too high, parts of
/// rows are inserted between them. Chords between the CL points are not checked:
/// BufferPoints does that.
template <typename PointT>
class CLSurface : public Stage<PointT, PointCL> {
public:
  CLSurface() : Stage<PointT, PointCL>("CLSurface") {}

  void setTool(const Tool& tool) { raster_.tool = tool; }
  const Tool& getTool() const { return raster_.tool; }
  /// @brief Distance between the regular rows [mm].
  void setStepOver(double step) { raster_.step_over = step; }
  double getStepOver() const { return raster_.step_over; }
  /// @brief Scallops are to be no higher than this [mm]: sets the step-over that leaves
  /// them on a flat, and inserts rows where the ground falls or curves. The tool must
  /// be set before.
  void setScallop(double height)
  {
    raster_.scallop = height;
    raster_.step_over = stepOverForScallop(raster_.tool.corner_radius, height);
  }
  double getScallop() const { return raster_.scallop; }
  /// @brief Inserted rows come no nearer to each other than this [mm].
  void setMinStepOver(double step) { raster_.min_step_over = step; }
  double getMinStepOver() const { return raster_.min_step_over; }
  /// @brief Distance between CL points on a row [mm].
  void setForwardStep(double step) { raster_.forward_step = step; }
  double getForwardStep() const { return raster_.forward_step; }
  /// @brief Material to leave on the part, along its normal [mm].
  void setAllowance(double allowance) { raster_.allowance = allowance; }
  double getAllowance() const { return raster_.allowance; }
  /// @brief The tip goes no lower than this [mm]; by default the lowest point.
  void setFloor(double floor) { floor_ = floor; }
  void setDirection(RasterDirection direction)
  {
    raster_.angle = direction == RasterDirection::AlongY ? 90 : 0;
    choose_ = direction == RasterDirection::Auto;
  }
  /// @brief Rows at any angle to X [degrees]: 0 is along X, 90 along Y.
  void setAngle(double degrees)
  {
    raster_.angle = degrees;
    choose_ = false;
  }
  double getAngle() const { return raster_.angle; }
  /// @brief Where the rows cannot hold the scallop, however near to each other, a
  /// second raster goes across them.
  void setAcross(bool across) { raster_.across = across; }
  bool getAcross() const { return raster_.across; }
  void setPattern(RasterPattern pattern) { raster_.pattern = pattern; }
  /// @brief For one-way rows.
  void setMillingMode(MillingMode mode) { raster_.mode = mode; }
  /// @brief Keeps the tool's axis inside a polygon [mm]; without one the rows go
  /// wherever the tool touches points. Beside the points there are none either way.
  void setBoundary(std::vector<Eigen::Vector2d> polygon)
  {
    polygon_ = std::move(polygon);
  }
  /// @brief Keeps the tool's axis over the stock.
  void setBoundary(const Stock& stock)
  {
    polygon_ = {stock.min.head<2>(),
                {stock.max.x(), stock.min.y()},
                stock.max.head<2>(),
                {stock.min.x(), stock.max.y()}};
  }
  /// @brief How far the axis may leave the boundary [mm], outwards, or must keep inside
  /// it where this is negative.
  void setOverhang(double overhang) { overhang_ = overhang; }
  double getOverhang() const { return overhang_; }
  /// @brief Rows end where the tool would come nearer to a keep-out zone than the
  /// margin; they do not climb over it. What joins the CL points, and what BufferPoints
  /// inserts between them, is clear as well.
  void setKeepOut(KeepOut keep_out) { raster_.keep_out = std::move(keep_out); }
  const KeepOut& getKeepOut() const { return raster_.keep_out; }
  /// @brief A model of the same points (and of what bridges their gaps), so that
  /// several stages share it. By default the stage takes its input's bare points.
  void setModel(std::shared_ptr<const SurfaceModel> model)
  {
    model_ = std::move(model);
  }
  void setNumberOfThreads(unsigned threads) { raster_.threads = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("step_over",
      raster_.step_over,
      "mm",
      Range{0.001, 100},
      "distance between the regular rows");
    v("scallop",
      raster_.scallop,
      "mm",
      Range{0, 10},
      "rows are inserted where scallops would be higher; 0: nowhere");
    v("min_step_over",
      raster_.min_step_over,
      "mm",
      Range{0.001, 100},
      "inserted rows come no nearer to each other");
    v("forward_step",
      raster_.forward_step,
      "mm",
      Range{0.001, 100},
      "distance between CL points");
    v("allowance", raster_.allowance, "mm", Range{0, 20}, "material left on the part");
    v("angle", raster_.angle, "deg", Range{-360, 360}, "of the rows to X");
    v("overhang",
      overhang_,
      "mm",
      Range{-100, 100},
      "how far the tool's axis may leave the boundary");
  }

protected:
  void checkParameters() const override
  {
    validateParameters(*this, this->getName());
    raster_.tool.validate();
  }
  void apply(CLCloud& output) override;

private:
  Raster raster_;
  std::vector<Eigen::Vector2d> polygon_;
  double overhang_ = 0.0, floor_ = -std::numeric_limits<double>::infinity();
  bool choose_ = false;
  std::shared_ptr<const SurfaceModel> model_;
};

} // namespace pointmill

#include <pointmill/finish/impl/cl_surface.hpp>

namespace pointmill {
extern template class CLSurface<pcl::PointXYZ>;
extern template class CLSurface<pcl::PointXYZI>;
extern template class CLSurface<pcl::PointXYZRGB>;
extern template class CLSurface<pcl::PointXYZRGBA>;
extern template class CLSurface<pcl::PointNormal>;
} // namespace pointmill
