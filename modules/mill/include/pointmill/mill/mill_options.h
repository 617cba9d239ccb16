// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/align/z_alignment.h>
#include <pointmill/common/keep_out.h>
#include <pointmill/common/machine.h>
#include <pointmill/common/operation.h>
#include <pointmill/common/stock.h>
#include <pointmill/finish/cl_surface.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/slice/occupancy_map.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pointmill {

/// Step-over of the roughing, in diameters, by default.
constexpr double kRoughStepOver = 0.4;

/// @brief How the roughing goes over a level.
enum class RoughingStrategy { Grid, ZigZag, Spiral, HighSpeed, Offset };

/// @brief What the cutters rest on between the points of the scan.
enum class SurfaceChoice {
  Auto,   ///< smooth where the scan is noisy or sparse for the tolerance
  Points, ///< bare points
  Smooth  ///< noise taken off, quadrics between the points
};

/// @brief What one tool does, as a user sets it.
struct ToolJob {
  Tool tool;
  Cutting cutting;
  double allowance = 0; ///< material to leave, mm
};

/// @brief Everything that can be said about the job of milling one scan. The defaults
/// are the papers' tools (roughing flat 10 mm, semi-finishing ball 5 mm, finishing ball
/// 3 mm) with feeds and speeds for aluminium on a small machine.
struct MillOptions {
  // the scan
  double mm_per_unit = 1.0;
  double fit = 0.0; ///< 0: off; largest extent of the part [mm]
  Up up = Up::Z;
  bool square = true;
  DatumXY datum_xy = DatumXY::Corner;
  DatumZ datum_z = DatumZ::Top;
  bool remove_strays = true;
  GapPolicy gaps = GapPolicy::Bridge;
  /// Places of the part frame [mm], each in a gap that is a hole through the part.
  std::vector<Eigen::Vector2d> through_holes;
  std::uint32_t seed = 1;

  // accuracy
  double tolerance = 0.02; ///< deepest a point may get into a tool, all errors together
  double scallop = 0.01;   ///< of the finishing [mm]
  SurfaceChoice surface = SurfaceChoice::Auto;
  /// Standard deviation of the scanner's noise [mm]; NaN: measured on the scan.
  double noise = std::numeric_limits<double>::quiet_NaN();
  /// Go on where a tool may sink further between bare points than the tolerance.
  bool accept_sparse = false;
  double semi_scallop = 0.05;
  double cell = 0.0; ///< of the map [mm]; 0: from tool and spacing

  // the machine
  double clearance = 5.0; ///< rapids go sideways so far above the stock [mm]
  Machine machine;
  double stock_margin = 0.0; ///< stock beyond the part on each side in X and Y [mm]
  double stock_top = 0.0;    ///< stock above the part's highest point [mm]
  double stock_bottom = 0.0; ///< stock below the part's lowest point [mm]
  /// The stock's box in the part frame [mm], instead of margins round the part.
  std::optional<Stock> stock_box;
  /// File of a scan of the raw part, in the frame and the units of the part's own;
  /// empty: a box.
  std::string stock_scan;
  /// Z that no tip goes below [mm]; NaN: the part's lowest point.
  double floor = std::numeric_limits<double>::quiet_NaN();

  // the operations
  RoughingStrategy roughing = RoughingStrategy::Offset;
  double step_down = 0.0; ///< of the roughing; 0: 0.3 d / 4
  double step_over = 0.0; ///< of the roughing; 0: 0.4 d
  /// Level ground that gets a level of the roughing [mm2]; NaN: the tool's end squared.
  double min_flat = std::numeric_limits<double>::quiet_NaN();
  KeepOut keep_out; ///< where no tool may be, in the part frame: clamps
  RasterDirection raster = RasterDirection::Auto;
  RasterPattern pattern = RasterPattern::ZigZag;
  MillingMode milling = MillingMode::Climb; ///< of one-way rows
  /// Semi-finishing and finishing keep the tool's axis inside this polygon of the part
  /// frame [mm]; empty: wherever the tool touches the part.
  std::vector<Eigen::Vector2d> boundary;
  bool over_stock = false; ///< the boundary is the stock, where no polygon is given
  double overhang = 0.0;   ///< beyond the boundary [mm]
  ToolJob rough{Tool::flat(1, 10.0), {8000, 1200, 300, true}, 0.5};
  std::optional<ToolJob> rest; ///< cuts what the roughing tool left, where given
  ToolJob semi{Tool::ball(2, 5.0), {12000, 1200, 300, true}, 0.2};
  ToolJob finish{Tool::ball(3, 3.0), {16000, 1000, 300, true}, 0.0};

  // the program
  /// How programs are written; the job adds what it knows itself.
  GCodeWriter writer;
  bool arcs = true;   ///< where the control takes them
  bool force = false; ///< write a program that fails its verification, and say so in it

  double residual_limit = 0.5; ///< refuse where half of the points keep more [mm]
  unsigned threads = 0;

  /// @brief Of the roughing, by default too [mm].
  double stepDown() const;
  double stepOver() const;

  /// @throws ParameterError
  void validate() const;
};

/// @brief How the tolerance is spent.
struct ErrorBudget {
  double chord;    ///< chords against the true cutter-location curve
  double arcs;     ///< arcs and longer lines against these chords
  double blend;    ///< the control's rounding of corners (G64 P)
  double rounding; ///< of the program's decimals and of float32

  static ErrorBudget of(double tolerance);
};

} // namespace pointmill
