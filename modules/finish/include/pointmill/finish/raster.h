// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/milling_mode.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/tool.h>
#include <pointmill/finish/boundary.h>
#include <pointmill/surface/surface_model.h>

#include <cmath>
#include <limits>

namespace pointmill {

/// @brief Step-over [mm] at which a ball (or the corner of a bull nose) of radius @p r
/// leaves scallops of height @p h on a flat: `2 sqrt(2 r h - h^2)`.
inline double stepOverForScallop(double r, double h)
{
  return 2 * std::sqrt(std::max(0.0, 2 * r * h - h * h));
}

/// @brief The way that a raster's rows run. Auto: along X or Y, whichever is milled
/// sooner, see rasterAngle().
enum class RasterDirection { AlongX, AlongY, Auto };

/// @brief How rows follow each other: forth and back in turn, or all the same way.
enum class RasterPattern { ZigZag, OneWay };

/// @brief Passes of a raster and what they leave.
struct RasterPasses {
  CLCloud path; ///< `label` numbers the passes

  std::size_t passes = 0;
  std::size_t inserted = 0; ///< of these, parts of rows between the regular ones
  std::size_t across = 0;   ///< of these, passes of the raster across
  double scallop_p95 = 0; ///< predicted height that 95 % of the ground stay under [mm]
  double scallop_max = 0; ///< the highest; where rows miss each other the corner radius
  double left = 0;        ///< XY area on which scallops stay too high [mm2]
  double kept_out = 0;    ///< length of rows that keep-out zones take [mm]
};

/// @brief Parallel rows over the cutter-location surface: what CLSurface does once it
/// has a model. Lengths in mm, angles in degrees.
struct Raster {
  Tool tool = Tool::ball(1, 3.0);
  double step_over = 0.35;   ///< between the regular rows
  double forward_step = 0.5; ///< between CL points of a row
  double allowance = 0.0;    ///< left on the part, along its normal
  double floor = 0.0;        ///< the tip goes no lower
  double scallop = 0.0; ///< rows are inserted where it would be higher; 0: none are
  double min_step_over = 0.02; ///< rows come no nearer to each other
  double angle = 0.0;          ///< of the rows to X
  bool across =
      false; ///< a second raster goes across where rows cannot hold the scallop
  RasterPattern pattern = RasterPattern::ZigZag;
  MillingMode mode = MillingMode::Climb;
  Boundary boundary;
  KeepOut keep_out; ///< rows end where the tool would come nearer to a zone than margin
  unsigned threads = 0;

  RasterPasses over(const SurfaceModel& surface) const;
};

/// @brief 0 or 90: the direction of rows in which @p raster is milled sooner. The
/// ground's slopes along and across the rows are taken at some thousand places; they
/// give the length of the rows, how often their spacing is halved, and how slowly they
/// fall (plunge feed: a third of the feed). Each row costs a tool diameter more, for
/// the way to the next.
double rasterAngle(const Raster& raster, const SurfaceModel& surface);

} // namespace pointmill
