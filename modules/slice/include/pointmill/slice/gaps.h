// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/slice/cell_grid.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace pointmill {

/// @brief What becomes of the parts of a scan that hold no points.
enum class GapPolicy {
  Bridge, ///< a membrane over the gap's rim is protected; nothing is cut below it
  Keep,   ///< the stock over the gap is left standing at full height
  Mill    ///< taken for a hole: milled to the floor like the outside
};

/// @brief What a gap is. A scan does not tell: only its user knows that the part has a
/// hole.
enum class GapKind {
  NotScanned, ///< there is or may be a surface that the scanner did not see
  ThroughHole ///< said to be one, see OccupancyMap::setThroughHoles()
};

/// @brief A connected part of the scan that holds no points though the part is all
/// round. What lies outside the part's outline is no gap.
struct GapRegion {
  double area = 0;                                  ///< mm2
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< mm
  Eigen::Vector2d min = Eigen::Vector2d::Zero();    ///< bounding box, mm
  Eigen::Vector2d max = Eigen::Vector2d::Zero();
  /// @brief Lowest and highest of the cells beside it [mm]; NaN where none has a height
  double rim_low = std::numeric_limits<double>::quiet_NaN();
  double rim_high = std::numeric_limits<double>::quiet_NaN();
  bool open =
      false; ///< joins the outside, through a mouth narrower than twice the reach
  GapKind kind = GapKind::NotScanned;
  GapPolicy treatment = GapPolicy::Bridge;
  std::vector<std::size_t> cells; ///< CellGrid::index() of each
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
/// @param height of the cells, NaN where unknown; the rims are taken from it
std::vector<GapRegion> gapRegions(const CellGrid& grid,
                                  const std::vector<unsigned char>& gaps,
                                  const std::vector<double>& height);

/// @brief Makes through holes, to be milled, of the regions that hold one of @p places
/// [mm].
/// @throws ParameterError naming the nearest gap where a place lies in none; @p regions
/// are as they were then
void nameThroughHoles(const CellGrid& grid,
                      const std::vector<Eigen::Vector2d>& places,
                      std::vector<GapRegion>& regions);

/// @brief Heights for the cells of @p between, which lie between points: the plane
/// through the nearest eight points in XY, kept between their lowest and highest.
void fillBetweenPoints(const CellGrid& grid,
                       const std::vector<unsigned char>& between,
                       const std::vector<Eigen::Vector3f>& points,
                       std::vector<double>& height);

/// @brief Spans a membrane over the gaps: fills `height` there with the solution of
/// Laplace's equation whose border is the height of the adjoining occupied cells. It
/// nowhere goes below the lowest or above the highest place of its rim (the maximum
/// principle, held to the last bit), even where a gap is open to the outside: there the
/// membrane is free.
/// @throws DataError where a gap touches no point
void bridgeGaps(const CellGrid& grid,
                const std::vector<unsigned char>& gaps,
                std::vector<double>& height);

} // namespace pointmill
