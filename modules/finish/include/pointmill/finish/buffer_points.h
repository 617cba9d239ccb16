// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/finish/chord_refiner.h>

#include <memory>

namespace pointmill {

/// @brief Buffer points (paper 000): inserts CL points by bisection wherever a chord
/// errs from the true cutter-location curve by more than the tolerance, inside or
/// outside. Both are proven over the whole length of every chord, see ChordRefiner;
/// where the curve leaps (a wall's point enters the cutter's rim) the tool goes up or
/// down on the free side. CL points that stand too low are raised first. Over a smooth
/// surface model, what is proven against every point is that no chord cuts in; between
/// the points the chords follow the smooth surface.
///
/// Chords join consecutive points of one pass (`label`). `PointT` is the type of the
/// part's points, which come by setSurface() or as a model by setModel().
template <typename PointT>
class BufferPoints : public Filter<PointCL> {
public:
  BufferPoints() : Filter<PointCL>("BufferPoints") {}

  /// @brief The points of the part.
  void setSurface(const typename pcl::PointCloud<PointT>::ConstPtr& surface)
  {
    surface_ = surface;
    model_.reset();
  }
  /// @brief A model of the part's surface that is already there.
  void setModel(std::shared_ptr<const SurfaceModel> model)
  {
    model_ = std::move(model);
  }
  void setTool(const Tool& tool) { tool_ = tool; }
  void setAllowance(double allowance) { allowance_ = allowance; }
  /// @brief The tip goes no lower than this [mm]; by default the lowest point.
  void setFloor(double floor) { floor_ = floor; }
  /// @brief How far a chord may err, into the part and above the curve [mm].
  void setTolerance(double tolerance) { band_ = {tolerance, tolerance}; }
  void setTolerance(const ToleranceBand& band) { band_ = band; }
  const ToleranceBand& getTolerance() const { return band_; }
  /// @brief Chords are not split below this length in XY [mm].
  void setShortestChord(double shortest) { shortest_ = shortest; }
  double getShortestChord() const { return shortest_; }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("inside_tolerance",
      band_.inside,
      "mm",
      Range{1e-5, 10},
      "how far a chord may cut in");
    v("outside_tolerance",
      band_.outside,
      "mm",
      Range{1e-5, 10},
      "how far a chord may stay above the curve");
    v("shortest_chord", shortest_, "mm", Range{1e-4, 10}, "shortest chord in XY");
    v("allowance", allowance_, "mm", Range{0, 20}, "material left on the part");
  }

protected:
  void checkParameters() const override
  {
    validateParameters(*this, getName());
    tool_.validate();
    if (!model_ && !surface_)
      throw DataError("BufferPoints: the part's points were not given (setSurface)");
  }
  void apply(CLCloud& output) override;

private:
  typename pcl::PointCloud<PointT>::ConstPtr surface_;
  std::shared_ptr<const SurfaceModel> model_;
  Tool tool_ = Tool::ball(1, 3.0);
  double allowance_ = 0.0, floor_ = -std::numeric_limits<double>::infinity();
  ToleranceBand band_{0.01, 0.01};
  double shortest_ = 0.02;
  unsigned threads_ = 0;
};

} // namespace pointmill

#include <pointmill/finish/impl/buffer_points.hpp>

namespace pointmill {
extern template class BufferPoints<pcl::PointXYZ>;
extern template class BufferPoints<pcl::PointXYZI>;
extern template class BufferPoints<pcl::PointXYZRGB>;
extern template class BufferPoints<pcl::PointXYZRGBA>;
extern template class BufferPoints<pcl::PointNormal>;
} // namespace pointmill
