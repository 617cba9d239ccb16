// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/surface/point_index.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace pointmill {

/// @brief How far a point may be moved [mm].
struct MostMoved {
  double down; ///< into the part
  double up;   ///< out of it
};

/// @brief What smoothing does to one point.
struct Smoothed {
  Eigen::Vector3d place; ///< where the point goes [mm]
  double variance = 1.0; ///< of its height, as a share of the noise's variance
  enum class How {
    Surface, ///< onto the quadric through its neighbours
    Edge,    ///< onto that of its neighbours on one side
    Kept     ///< left where it is: no quadric fits its neighbours
  } how = How::Kept;
  bool held = false; ///< it stopped at the farthest it may go
};

/// @brief Takes the noise off one point: onto a quadric fitted to its neighbours in
/// their plane, the largest neighbourhood that such a surface fits to within the noise.
/// Beside an edge the neighbours on one side serve; where nothing fits, the point
/// stays.
/// @param points all points, with their noise
/// @param noise standard deviation along the normal [mm]
/// @param neighbours of the largest neighbourhood
Smoothed smoothPoint(const PointIndex& points,
                     const Eigen::Vector3d& point,
                     double noise,
                     int neighbours,
                     const MostMoved& most);

/// @brief Takes a scanner's noise off its points, edges kept; see smoothPoint(). No
/// point moves by more than three times the noise, so a cutter that enters no smoothed
/// point by more than a tolerance enters no point of the scan by more than that and
/// three times the noise. How far points may be raised can be limited further: where a
/// scan is so sparse that the cutter reaches single low points, that much is left above
/// them at most; where it is dense their neighbours hold the cutter up all the same.
/// Fields besides x, y, z stay as they are.
template <typename PointT>
class PointSmoother : public Filter<PointT> {
public:
  using PointCloud = typename Filter<PointT>::PointCloud;

  PointSmoother() : Filter<PointT>("PointSmoother") {}

  /// @brief Standard deviation of the noise along the surface normal [mm]; there is no
  /// default.
  void setNoise(double noise) { noise_ = noise; }
  double getNoise() const { return noise_; }
  /// @brief Points of the largest neighbourhood. What is left of the noise is about
  /// `2 / sqrt(neighbours)` of it.
  void setNeighbours(int neighbours) { neighbours_ = neighbours; }
  int getNeighbours() const { return neighbours_; }
  /// @brief How far a point may move [mm].
  double getFarthest() const { return 3 * noise_; }
  /// @brief How far a point may be raised, out of the part [mm]; three times the noise
  /// where that is less.
  void setMostRaised(double raised) { most_raised_ = raised; }
  double getMostRaised() const { return most_raised_; }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("noise", noise_, "mm", Range{1e-6, 100}, "standard deviation of the noise");
    v("most_raised", most_raised_, "mm", Range{0, 300}, "no point goes further up");
    v("neighbours", neighbours_, "", Range{12, 5000}, "most points that a fit takes");
  }

protected:
  void checkParameters() const override { validateParameters(*this, this->getName()); }
  void apply(PointCloud& output) override;

private:
  double noise_ = std::numeric_limits<double>::quiet_NaN(); // must be set
  double most_raised_ = 300.0;
  int neighbours_ = 100;
  unsigned threads_ = 0;
};

} // namespace pointmill

#include <pointmill/surface/impl/point_smoother.hpp>

namespace pointmill {
extern template class PointSmoother<pcl::PointXYZ>;
extern template class PointSmoother<pcl::PointXYZI>;
extern template class PointSmoother<pcl::PointXYZRGB>;
extern template class PointSmoother<pcl::PointXYZRGBA>;
extern template class PointSmoother<pcl::PointNormal>;
} // namespace pointmill
