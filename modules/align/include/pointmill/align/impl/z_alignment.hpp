// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/align/rectangle.h>
#include <pointmill/align/rotation.h>
#include <pointmill/align/z_alignment.h>

#include <pcl/type_traits.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <vector>

namespace pointmill {
namespace align {

// An axis found in noisy points that is so near to Z is Z: a part that has been aligned
// stays as it is. 2 um over 100 mm.
constexpr double level_tolerance = 2e-5;

/// @brief The box around @p points.
inline void bounds(const Points& points, Eigen::Vector3d& low, Eigen::Vector3d& high)
{
  low.setConstant(std::numeric_limits<double>::max());
  high = -low;
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
}

} // namespace align

template <typename PointT>
void ZAlignment<PointT>::checkParameters() const
{
  validateParameters(*this, this->getName());
  if (own_axis_ && !(axis_.allFinite() && axis_.stableNorm() > 0.0))
    throw ParameterError(this->getName() + ": the axis that is up has no direction");
}

template <typename PointT>
align::UpDirection ZAlignment<PointT>::findUp(const align::Points& points,
                                              const Eigen::Vector3d& hint) const
{
  align::UpDirection up;
  if (own_axis_)
    up.axis = axis_.stableNormalized();
  else if (up_ == Up::Plane || up_ == Up::Pca) {
    up = up_ == Up::Plane ? align::baseNormal(points, plane_, hint, this->getName())
                          : align::thinnestDirection(points, hint, this->getName());
    if ((up.axis - Eigen::Vector3d::UnitZ()).norm() < align::level_tolerance)
      up.axis = Eigen::Vector3d::UnitZ();
  }
  else {
    const int which = static_cast<int>(up_);
    up.axis = (which % 2 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(which / 2);
  }
  return up;
}

template <typename PointT>
void ZAlignment<PointT>::apply(PointCloud& output)
{
  constexpr bool has_normals = pcl::traits::has_normal<PointT>::value;
  align::Points points;
  Eigen::Vector3d hint = Eigen::Vector3d::Zero();
  points.reserve(this->indices_->size());
  for (const auto i : *this->indices_) {
    const PointT& p = (*this->input_)[i];
    const Eigen::Vector3d position(p.x, p.y, p.z);
    if (!position.allFinite())
      continue;
    points.push_back(position);
    output.push_back(p);
    if constexpr (has_normals) {
      const Eigen::Vector3d normal(p.normal_x, p.normal_y, p.normal_z);
      if (normal.allFinite())
        hint += normal;
    }
  }
  if (points.size() < 3)
    throw DataError(this->getName() + ": " + std::to_string(points.size()) +
                    " finite points; an alignment needs three");

  Eigen::Vector3d low, high;
  align::bounds(points, low, high);
  const Eigen::Vector3d middle = low + (high - low) / 2;
  for (auto& p : points)
    p -= middle;
  // Normals that were never turned to one side cancel out: they say nothing.
  if (hint.norm() < 0.1 * static_cast<double>(points.size()))
    hint.setZero();
  const Eigen::Vector3d sensor =
      this->input_->sensor_origin_.template head<3>().template cast<double>();
  if (hint.isZero(0.0) && !sensor.isZero(0.0))
    hint = sensor - middle;

  const align::UpDirection up = findUp(points, hint);
  Eigen::Matrix3d rotation = align::rotationToZ(up.axis);
  double angle = 0.0;
  if (square_) {
    std::vector<Eigen::Vector2d> outline;
    outline.reserve(points.size());
    for (const auto& p : points)
      outline.emplace_back(rotation.template topRows<2>() * p);
    angle = align::squaringAngle(align::convexHull(std::move(outline)));
    rotation = align::orthonormalised(
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * rotation);
  }
  for (auto& p : points)
    p = rotation * p;

  align::bounds(points, low, high);
  Eigen::Vector3d datum = low;
  if (datum_xy_ == DatumXY::Centre)
    datum.template head<2>() += (high - low).template head<2>() / 2;
  if (datum_z_ == DatumZ::Top)
    datum.z() = high.z();
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointT& p = output[i];
    p.getVector3fMap() = (points[i] - datum).template cast<float>();
    if constexpr (has_normals)
      p.getNormalVector3fMap() =
          (rotation * p.getNormalVector3fMap().template cast<double>())
              .template cast<float>();
  }

  min_ = low - datum;
  max_ = high - datum;
  transform_.setIdentity();
  transform_.template topLeftCorner<3, 3>() = rotation;
  transform_.template topRightCorner<3, 1>() = -(rotation * middle + datum);

  constexpr double degrees = 180.0 / 3.14159265358979323846;
  auto& report = this->report_;
  report.set("points", static_cast<double>(points.size()));
  report.set("nan_points", static_cast<double>(this->indices_->size() - points.size()));
  report.set("tilt_deg",
             degrees * std::atan2(up.axis.template head<2>().norm(), up.axis.z()));
  report.set("angle_deg", degrees * angle);
  if (!own_axis_ && (up_ == Up::Plane || up_ == Up::Pca)) {
    report.set("up_evidence", up.evidence);
    report.set("base_share", up.base_share);
  }
  report.set("length_mm", getExtents().x());
  report.set("width_mm", getExtents().y());
  report.set("height_mm", getExtents().z());
}

} // namespace pointmill
