// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief A connected part of the scan that holds no points though the part is all
/// round.
struct GapRegion {
  double area = 0;                                  ///< mm2
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< mm
  Eigen::Vector2d min = Eigen::Vector2d::Zero();    ///< bounding box, mm
  Eigen::Vector2d max = Eigen::Vector2d::Zero();
};

/// @brief The empty cells inside the outline of the occupied ones. The outline is the
/// occupied cells closed (dilated, then eroded) by @p reach mm, with all that it
/// encloses.
/// @param occupied row-major over @p grid, 1 where a cell holds points
/// @return 1 for the cells of a gap
std::vector<unsigned char> findGaps(const CellGrid& grid,
                                    const std::vector<unsigned char>& occupied,
                                    double reach);

/// @brief The cells of @p gaps that are real gaps: those about places further than
/// @p reach mm from any point's cell. The others just lie between points.
std::vector<unsigned char> wideGaps(const CellGrid& grid,
                                    const std::vector<unsigned char>& occupied,
                                    const std::vector<unsigned char>& gaps,
                                    double reach);

/// @brief The regions that the cells of @p gaps form, largest first.
std::vector<GapRegion> gapRegions(const CellGrid& grid,
                                  const std::vector<unsigned char>& gaps);

/// @brief Heights for the cells of @p between, which lie between points: the plane
/// through the nearest eight points in XY, kept between their lowest and highest.
void fillBetweenPoints(const CellGrid& grid,
                       const std::vector<unsigned char>& between,
                       const std::vector<Eigen::Vector3f>& points,
                       std::vector<double>& height);

/// @brief Spans a membrane over the gaps: fills `height` there with the solution of
/// Laplace's equation whose border is the height of the adjoining occupied cells. It
/// nowhere goes below the lowest or above the highest place of its rim.
void bridgeGaps(const CellGrid& grid,
                const std::vector<unsigned char>& gaps,
                std::vector<double>& height);

} // namespace pointmill
