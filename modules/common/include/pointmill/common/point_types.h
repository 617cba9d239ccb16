// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/pcl_macros.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

// PCLBase of an own point type needs its implementation in sight.
#include <pcl/impl/pcl_base.hpp>

#include <cstdint>
#include <limits>

namespace pointmill {

/// @brief How the tool arrives at a CL point.
enum class Motion : std::uint32_t {
  Rapid = 0, ///< traverse in the air
  Plunge,    ///< straight down at plunge feed
  Ramp,      ///< down along the path at a bounded angle
  LeadIn,
  Cut,
  LeadOut,
  Link,   ///< feed move between two passes, proven clear of the part
  Retract ///< straight up
};

/// @brief What is known about one cell of an occupancy map.
enum class CellState : std::uint32_t {
  Empty = 0,    ///< outside the part's outline: milled (yellow)
  Occupied = 1, ///< holds points (red)
  Gap = 2,      ///< inside the outline without points: not scanned, protected
  Between = 3   ///< holds none, but lies between points that are near: part
};

struct EIGEN_ALIGN16 _PointCL {
  PCL_ADD_POINT4D;
  PCL_ADD_NORMAL4D;
  union {
    struct {
      float feed;
      std::uint32_t label;
      std::uint32_t level;
      std::uint32_t motion;
    };
    float data_c[4];
  };
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/// @brief One cutter location. `x y z` is the tool's **tip** in the part frame [mm],
/// `normal` the surface normal at the contact, `feed` in mm/min, `label` the pass
/// number, `level` the slice number and `motion` how the tool arrives (@ref Motion).
/// The order of a CL cloud is the machining order.
struct PointCL : public _PointCL {
  PointCL()
  {
    x = y = z = 0.f;
    data[3] = 1.f;
    normal_x = normal_y = 0.f;
    normal_z = 1.f;
    data_n[3] = 0.f;
    feed = 0.f;
    label = level = 0;
    motion = static_cast<std::uint32_t>(Motion::Cut);
  }
  PointCL(double px, double py, double pz, Motion how = Motion::Cut) : PointCL()
  {
    x = static_cast<float>(px);
    y = static_cast<float>(py);
    z = static_cast<float>(pz);
    motion = static_cast<std::uint32_t>(how);
  }
  Motion getMotion() const { return static_cast<Motion>(motion); }
  void setMotion(Motion how) { motion = static_cast<std::uint32_t>(how); }
};

struct EIGEN_ALIGN16 _PointCell {
  PCL_ADD_POINT4D;
  union {
    struct {
      std::uint32_t label;
      std::uint32_t count;
    };
    float data_c[4];
  };
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/// @brief One cell of an organised occupancy map (width = columns along X, height =
/// rows along Y). `x y` is the cell's centre [mm]; `z` is the highest point in it, the
/// bridge over a gap, or NaN outside the outline; `label` is its @ref CellState and
/// `count` the number of its points.
struct PointCell : public _PointCell {
  PointCell()
  {
    x = y = 0.f;
    z = std::numeric_limits<float>::quiet_NaN();
    data[3] = 1.f;
    label = static_cast<std::uint32_t>(CellState::Empty);
    count = 0;
  }
  CellState getState() const { return static_cast<CellState>(label); }
  void setState(CellState state) { label = static_cast<std::uint32_t>(state); }
};

using CLCloud = pcl::PointCloud<PointCL>;
using CellCloud = pcl::PointCloud<PointCell>;

} // namespace pointmill

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(pointmill::_PointCL,
    (float, x, x)(float, y, y)(float, z, z)
    (float, normal_x, normal_x)(float, normal_y, normal_y)(float, normal_z, normal_z)
    (float, feed, feed)(std::uint32_t, label, label)
    (std::uint32_t, level, level)(std::uint32_t, motion, motion))
POINT_CLOUD_REGISTER_POINT_WRAPPER(pointmill::PointCL, pointmill::_PointCL)
POINT_CLOUD_REGISTER_POINT_STRUCT(pointmill::_PointCell,
    (float, x, x)(float, y, y)(float, z, z)
    (std::uint32_t, label, label)(std::uint32_t, count, count))
POINT_CLOUD_REGISTER_POINT_WRAPPER(pointmill::PointCell, pointmill::_PointCell)
// clang-format on
