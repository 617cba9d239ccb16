// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/surface/point_index.h>

#include <Eigen/Core>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pointmill {

/// @brief Something about a program that must not be.
struct Finding {
  std::string code; ///< "gouge", "rapid_in_stock", ...
  std::string text; ///< one line for people
  double worst = 0; ///< mm, where it is a length
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::size_t line = 0; ///< of the program, 0: none
};

/// @brief p50, p95, p99 and the largest of some lengths [mm].
struct Quantiles {
  double p50 = 0, p95 = 0, p99 = 0, max = 0;
};

/// @brief What a program does to the part and the stock.
struct Verification {
  double gouge = 0; ///< deepest that any point gets inside a moving tool [mm]
  Eigen::Vector3d gouge_at = Eigen::Vector3d::Zero();
  std::size_t gouge_line = 0;
  std::size_t gouged_points = 0; ///< deeper than the tolerance

  /// @name With a model, which the figures above and below are about then: the same of
  /// the measured points
  /// @{
  double raw_gouge = 0; ///< [mm]
  Eigen::Vector3d raw_gouge_at = Eigen::Vector3d::Zero();
  std::size_t raw_gouge_line = 0;
  std::size_t raw_gouged_points = 0; ///< deeper than tolerance and noise allowance
  Quantiles raw_deviation;
  /// @}

  /// @brief Material left over a point beyond what a perfect pass of the last tool
  /// would leave there.
  Quantiles residual;
  /// @brief Cut surface minus point, over the points that the last tool can reach.
  Quantiles deviation;
  std::size_t points = 0;
  std::size_t unreachable_points = 0; ///< under the last tool's envelope
  /// Of the unreachable those that it would reach if there were no keep-out zones: what
  /// stays uncut because of them, and is in no residual.
  std::size_t kept_out_points = 0;
  std::size_t untouched_points = 0; ///< no tool passes over them

  std::size_t rapids_in_stock = 0;
  double rapid_depth = 0; ///< deepest of them [mm]
  std::size_t rapid_line = 0;

  /// How deep a tool gets into keep-out zones and the margin round them [mm]
  double keep_out_depth = 0;
  Eigen::Vector3d keep_out_at = Eigen::Vector3d::Zero(); ///< end of that move
  std::size_t keep_out_line = 0;
  std::size_t keep_out_moves = 0; ///< deeper than the tolerance

  /// Thickest layer that each tool takes at once [mm]: on a piece of a move of no more
  /// than a quarter of its diameter, where it is about an eighth of it wide and long.
  std::map<int, double> axial_depth;
  std::map<int, double> lowest_tip; ///< per tool [mm]

  std::size_t feed_moves = 0, rapid_moves = 0;
  double feed_length = 0, rapid_length = 0; ///< mm

  CellCloud milled; ///< the stock after the program, an organised height field
  std::vector<Finding> findings;

  bool good() const { return findings.empty(); }
};

/// @brief Judges a program as it was read back from its text: its moves are swept over
/// every point of the part, past every keep-out zone and through the stock.
///
/// The axes of a rapid (G0) need not arrive at once: one that moves along several must
/// be clear wherever the tip may come in the box between its ends, at its lowest
/// height.
///
/// Gouges are measured against the points, exactly, as penetration(); the stock is a
/// height field that is exact at the centres of its cells. Results do not depend on the
/// number of threads.
class ProgramVerifier {
public:
  /// @brief The points of the part, without anything that was added to them.
  void setPart(std::shared_ptr<const PointIndex> part) { part_ = std::move(part); }
  /// @brief The points of the part as they lie on its smoothed surface, one beside each
  /// measured point. With them the program is judged by the model, and the measured
  /// points only must not be gouged deeper than tolerance and noise allowance together.
  void setModel(std::shared_ptr<const PointIndex> model) { model_ = std::move(model); }
  /// @brief How far measured points may stick out of the model [mm].
  void setNoiseAllowance(double allowance) { noise_allowance_ = allowance; }
  /// @brief Places that are no points of the part but must be kept as if they were: the
  /// bridges over its gaps.
  void setProtected(std::shared_ptr<const PointIndex> places)
  {
    protected_ = std::move(places);
  }
  /// @brief How far the control may round corners and merge lines (G64 P and Q) [mm].
  void setBlendLimit(double limit) { blend_limit_ = limit; }
  /// @brief Where no tool may be, feeding or not.
  void setKeepOut(KeepOut keep_out) { keep_out_ = std::move(keep_out); }
  void setStock(const Stock& stock) { stock_ = stock; }
  /// @brief Points of the raw part, where the stock does not fill its box, and how far
  /// each stands for its surroundings [mm], see stockOf().
  void setRawStock(std::shared_ptr<const PointIndex> raw, double reach)
  {
    raw_ = std::move(raw);
    raw_reach_ = reach;
  }
  void setTools(std::vector<Tool> tools) { tools_ = std::move(tools); }
  /// @brief Points that get deeper into a tool than this are gouged [mm].
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  /// @brief Refuse a program that leaves more than this over half of the points [mm].
  void setResidualLimit(double limit) { residual_limit_ = limit; }
  /// @brief No tip is meant to go below this [mm]: what lies under it is not left over.
  void setFloor(double floor) { floor_ = floor; }
  /// @brief Edge of a stock cell [mm].
  void setCellSize(double cell) { cell_ = cell; }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("tolerance", tolerance_, "mm", Range{1e-4, 10}, "deepest gouge that passes");
    v("noise_allowance",
      noise_allowance_,
      "mm",
      Range{0, 10},
      "deeper gouge that passes at measured points beside a model");
    v("residual_limit",
      residual_limit_,
      "mm",
      Range{1e-3, 1e4},
      "most median residual");
    v("cell_size", cell_, "mm", Range{0.01, 50}, "edge of a stock cell");
  }

  /// @throws ParameterError, DataError for missing or absurd settings; what is wrong
  /// with
  ///         the program goes into the findings
  Verification verify(const Program& program) const;

private:
  std::shared_ptr<const PointIndex> part_, model_, protected_, raw_;
  double raw_reach_ = 0.0;
  KeepOut keep_out_;
  Stock stock_;
  std::vector<Tool> tools_;
  double tolerance_ = 0.02, noise_allowance_ = 0.0;
  double residual_limit_ = 1e4, cell_ = 0.25;
  double floor_ = -std::numeric_limits<double>::infinity();
  double blend_limit_ = std::numeric_limits<double>::infinity();
  unsigned threads_ = 0;
};

} // namespace pointmill
