// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pointmill {

/// @brief How far apart the points of a scan lie in XY, over the area that they cover.
///
/// A place's void is its distance to the nearest point. Each figure is the edge of the
/// square grid that has the same void there, so that all three are s on a square grid
/// of edge s. On random points of density rho, median and p99 are 1.18 and 1.84 /
/// sqrt(rho).
struct Spacing {
  double median = 0; ///< half of the places have a smaller void [mm]
  double p99 = 0;    ///< 99 % have, at least [mm]
  double worst = 0;  ///< of the largest void [mm]
  Eigen::Vector2d worst_at = Eigen::Vector2d::Zero(); ///< its middle [mm]
  double reach = 0; ///< voids of a larger radius count as gaps or outside [mm]
};

/// @brief The spacing, place by place.
struct SpacingField {
  CellGrid grid;
  /// @brief For each cell, row by row, sqrt(2) times the largest void that places in it
  /// grow into when they move away from the points [mm]; NaN where none of it is
  /// covered. See sinkBetweenPoints() for what it bounds.
  std::vector<float> spacing;
  std::vector<std::uint32_t> count; ///< points of each cell
  Spacing figures;
};

/// @brief Measures voids everywhere, with every point: each void grows from the
/// emptiest places of a raster, a quarter of the mean spacing wide, until points hold
/// it from all sides. Median and p99 are those of 200,000 seeded places.
///
/// What the points cover is their closing by a disc of radius @p reach: all places that
/// no disc without points gets to. Wider voids are gaps or lie outside the part;
/// findGaps() says the same of cells. A rim of about two spacings along the outline is
/// left out, since what lies beside the part is no void.
///
/// @param points finite
/// @param cell edge of the field's cells [mm]; 0: about 50 points in each
/// @param reach [mm]; 0: half as far again as one must look, at the median, to see
/// points on all sides (in each eighth of the circle)
/// @throws ParameterError where @p cell or @p reach is negative or makes too many
/// cells, DataError where there are no points or they cover no area
SpacingField mapSpacing(std::vector<Eigen::Vector3f> points,
                        double cell = 0,
                        double reach = 0,
                        std::uint32_t seed = 1);

/// @brief The figures alone. Points that are not finite are left out.
/// @throws as mapSpacing()
Spacing measureSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud,
                       std::uint32_t seed = 1);

} // namespace pointmill
