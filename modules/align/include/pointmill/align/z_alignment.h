// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/align/up_direction.h>
#include <pointmill/common/stage.h>

#include <Eigen/Core>

namespace pointmill {

/// @brief Which direction of the scan becomes the part's +Z.
enum class Up {
  X,
  MinusX,
  Y,
  MinusY,
  Z,
  MinusZ,
  Plane, ///< away from the largest plane, the base; see align::baseNormal()
  Pca    ///< the thinnest direction; see align::thinnestDirection()
};

/// @brief Where X0 Y0 lies on the bounding box.
enum class DatumXY {
  Corner, ///< at the smallest X and Y
  Centre
};

/// @brief Where Z0 lies on the bounding box.
enum class DatumZ { Top, Bottom };

/// @brief Moves a scan into the part frame by a rigid motion: the machined side to +Z,
/// the long side along X (align::squaringAngle()), the datum to the origin.
///
/// Everything is computed in double after the cloud's middle was subtracted, so that
/// far coordinates lose nothing further. Normals of points that have them turn along.
/// The output is dense and unorganised and keeps the order of the input; non-finite
/// points are dropped. The bounding box holds all finite points: remove strays first.
///
/// @note `Up::Plane` and `Up::Pca` take the side that stands out of the flat one for
/// the upper one. A plate whose top is its largest plane, as one with pockets only,
/// looks to them as if it lay upside down; name its axis instead. The figure
/// "up_evidence" of the report tells how clear the case was.
///
/// Report: "points", "nan_points", "tilt_deg" (between the scan's up and its Z),
/// "angle_deg" (about the part's Z), "up_evidence" and "base_share" (`Up::Plane`,
/// `Up::Pca`), "length_mm", "width_mm", "height_mm" (along X, Y, Z).
///
/// Source: Kukreja et al., "Direct Tool Path Planning for Roughing from Point Cloud
/// using Z-Segmentation", alignment step.
template <typename PointT>
class ZAlignment : public Filter<PointT> {
public:
  using PointCloud = typename Filter<PointT>::PointCloud;

  ZAlignment() : Filter<PointT>("ZAlignment") {}

  /// @brief Default: Up::Z. Overrules an earlier setUpAxis().
  void setUp(Up up)
  {
    up_ = up;
    own_axis_ = false;
  }
  Up getUp() const { return up_; }
  /// @brief Any direction of the scan, of any length but zero. Overrules setUp().
  void setUpAxis(const Eigen::Vector3d& axis)
  {
    axis_ = axis;
    own_axis_ = true;
  }
  const Eigen::Vector3d& getUpAxis() const { return axis_; }

  /// @brief Whether the part is turned about Z until its long side lies along X.
  /// Default: true
  void setSquareToX(bool square) { square_ = square; }
  bool getSquareToX() const { return square_; }

  /// @brief Default: DatumXY::Corner
  void setDatumXY(DatumXY datum) { datum_xy_ = datum; }
  DatumXY getDatumXY() const { return datum_xy_; }
  /// @brief Default: DatumZ::Top
  void setDatumZ(DatumZ datum) { datum_z_ = datum; }
  DatumZ getDatumZ() const { return datum_z_; }

  /// @brief How near a point of the base plane lies to it [mm]. Default: 0.1
  void setPlaneDistance(double distance) { plane_.distance = distance; }
  double getPlaneDistance() const { return plane_.distance; }
  /// @brief Most iterations of the search for the base plane. Default: 1000
  void setPlaneIterations(int iterations) { plane_.iterations = iterations; }
  int getPlaneIterations() const { return plane_.iterations; }
  /// @brief Smallest share of the points that makes a plane the base. Default: 0.05
  void setPlaneShare(double share) { plane_.share = share; }
  double getPlaneShare() const { return plane_.share; }

  /// @brief The motion of the last run, scan to part [mm]; its rotation is orthonormal
  /// with determinant +1. The identity before the first run.
  Eigen::Matrix4d getTransform() const { return transform_; }
  /// @brief The part's bounding box in the part frame [mm]; its z limits are those of
  /// the milling.
  const Eigen::Vector3d& getMin() const { return min_; }
  const Eigen::Vector3d& getMax() const { return max_; }
  Eigen::Vector3d getExtents() const { return max_ - min_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("plane_distance",
      plane_.distance,
      "mm",
      Range{0.001, 10},
      "how near a point of the base plane lies to it");
    v("plane_iterations",
      plane_.iterations,
      "",
      Range{10, 100000},
      "most iterations of the search for the base plane");
    v("plane_share",
      plane_.share,
      "",
      Range{0, 1},
      "smallest share of the points that makes a plane the base");
  }

protected:
  void checkParameters() const override;
  /// @throws DataError for less than three finite points; see baseNormal() and
  /// thinnestDirection()
  void apply(PointCloud& output) override;

private:
  align::UpDirection findUp(const align::Points& points,
                            const Eigen::Vector3d& hint) const;

  Up up_ = Up::Z;
  bool own_axis_ = false;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
  bool square_ = true;
  DatumXY datum_xy_ = DatumXY::Corner;
  DatumZ datum_z_ = DatumZ::Top;
  align::PlaneSearch plane_;

  Eigen::Matrix4d transform_ = Eigen::Matrix4d::Identity();
  Eigen::Vector3d min_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d max_ = Eigen::Vector3d::Zero();
};

} // namespace pointmill

#include <pointmill/align/impl/z_alignment.hpp>

namespace pointmill {
extern template class ZAlignment<pcl::PointXYZ>;
extern template class ZAlignment<pcl::PointXYZI>;
extern template class ZAlignment<pcl::PointXYZRGB>;
extern template class ZAlignment<pcl::PointXYZRGBA>;
extern template class ZAlignment<pcl::PointNormal>;
} // namespace pointmill
