// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/io/raw_scan.h>

#include <Eigen/Core>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pointmill {

/// @brief How large a scan becomes.
struct ScanScale {
  double mm_per_unit = 1.0; ///< 1 for mm, 1000 for m, 25.4 for inch
  /// @brief 0: off; else the largest extent in mm that the scan is scaled to, whatever
  /// `mm_per_unit` says.
  double fit_mm = 0.0;
};

/// @brief A scan in mm around the origin, where float32 is precise: each coordinate is
/// within 6e-8 of half the largest extent (0.02 um for 500 mm).
struct Scan {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud; ///< [mm], all finite
  Eigen::Vector3d shift{0, 0, 0}; ///< [mm]; added back gives the file's place in mm
  double scale = 1.0;             ///< mm per file unit that was used
  double density = 0.0; ///< samples per mm^2 of face that were placed; 0 for a cloud
  std::size_t vertices = 0; ///< the file's finite points, the cloud's first ones
  std::size_t faces = 0;    ///< the file's triangles
  std::size_t sampled = 0;  ///< points placed on the faces, after the vertices
  std::size_t non_finite = 0;
  std::string format;
};

/// @brief Scales, places points on the faces if there are any, recentres in double and
/// only then rounds to float.
///
/// The samples cover the faces evenly, so that no gap between them lets a cutter sink,
/// and are the same for the same @p seed, always.
///
/// @param density_per_mm2 samples per mm^2; lowered where they would exceed
/// @p max_points, which Scan::density tells
/// @throws ParameterError where scale, fit or density are not positive numbers,
/// DataError where the faces have no area or point outside the vertices
Scan prepareScan(const RawScan& raw,
                 const ScanScale& scale,
                 double density_per_mm2,
                 std::size_t max_points,
                 std::uint32_t seed);

} // namespace pointmill
