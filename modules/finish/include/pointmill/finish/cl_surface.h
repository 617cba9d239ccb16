// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/surface/surface_model.h>

#include <cmath>
#include <memory>

namespace pointmill {

/// @brief Step-over [mm] at which a ball (or the corner of a bull nose) of radius @p r
/// leaves scallops of height @p h on a flat: `2 sqrt(2 r h - h^2)`.
inline double stepOverForScallop(double r, double h)
{
  return 2 * std::sqrt(std::max(0.0, 2 * r * h - h * h));
}

/// @brief The way that a raster's lines run.
enum class RasterDirection { AlongX, AlongY };

/// @brief Raster lines over the cutter-location surface: the tip's height is
/// `max over the points under the cutter of p.z - profile(|p - c|)` (paper 000, 3.3.2,
/// corrected), every point counted. One pass (`label`) for every stretch of a line with
/// points under the cutter, lines in turn forth and back; `normal` is the surface
/// normal at the contact. Chords between the CL points are not checked: BufferPoints
/// does that.
template <typename PointT>
class CLSurface : public Stage<PointT, PointCL> {
public:
  CLSurface() : Stage<PointT, PointCL>("CLSurface") {}

  void setTool(const Tool& tool) { tool_ = tool; }
  const Tool& getTool() const { return tool_; }
  /// @brief Distance between lines [mm].
  void setStepOver(double step) { step_over_ = step; }
  double getStepOver() const { return step_over_; }
  /// @brief The step-over that leaves scallops of this height [mm] on a flat; the tool
  /// must be set before.
  void setScallop(double height)
  {
    step_over_ = stepOverForScallop(tool_.corner_radius, height);
  }
  /// @brief Distance between CL points on a line [mm].
  void setForwardStep(double step) { forward_step_ = step; }
  double getForwardStep() const { return forward_step_; }
  /// @brief Material to leave on the part, along its normal [mm].
  void setAllowance(double allowance) { allowance_ = allowance; }
  double getAllowance() const { return allowance_; }
  /// @brief The tip goes no lower than this [mm]; by default the lowest point.
  void setFloor(double floor) { floor_ = floor; }
  void setDirection(RasterDirection direction) { direction_ = direction; }
  /// @brief Keep only the stretches of the lines that climb or fall more steeply than
  /// this [degrees]; 0: all. A raster across the first one needs to go only where the
  /// first one's lines lie far apart on the surface.
  void setMinSlope(double degrees) { min_slope_ = degrees; }
  double getMinSlope() const { return min_slope_; }
  /// @brief A model of the same points (and of what bridges their gaps), so that
  /// several stages share it. By default the stage takes its input's bare points.
  void setModel(std::shared_ptr<const SurfaceModel> model)
  {
    model_ = std::move(model);
  }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("step_over",
      step_over_,
      "mm",
      Range{0.001, 100},
      "distance between raster lines");
    v("forward_step",
      forward_step_,
      "mm",
      Range{0.001, 100},
      "distance between CL points");
    v("allowance", allowance_, "mm", Range{0, 20}, "material left on the part");
    v("min_slope", min_slope_, "deg", Range{0, 89}, "flatter stretches are left out");
  }

protected:
  void checkParameters() const override
  {
    validateParameters(*this, this->getName());
    tool_.validate();
  }
  void apply(CLCloud& output) override;

private:
  Tool tool_ = Tool::ball(1, 3.0);
  double step_over_ = 0.35, forward_step_ = 0.5, allowance_ = 0.0, min_slope_ = 0.0;
  double floor_ = -std::numeric_limits<double>::infinity();
  RasterDirection direction_ = RasterDirection::AlongX;
  std::shared_ptr<const SurfaceModel> model_;
  unsigned threads_ = 0;
};

/// @brief The raster itself, on numbers: what CLSurface does once it has a model.
struct Raster {
  Tool tool;
  double step_over, forward_step, allowance, floor, min_slope;
  RasterDirection direction;
  unsigned threads;

  CLCloud over(const SurfaceModel& surface) const;
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
