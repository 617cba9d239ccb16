// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/machine.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/verify/finding.h>

#include <Eigen/Core>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pointmill {

/// @brief p1 .. p99 and the largest of some lengths [mm].
struct Quantiles {
  double p50 = 0, p90 = 0, p95 = 0, p99 = 0, max = 0;
  double p1 = 0, p5 = 0;
};

/// @brief What a section of the program does: an operation, or all by one tool where
/// the program does not say what its operations are.
struct SectionFigures {
  std::string name;     ///< as in the program; empty where it has none
  int tool = 0;         ///< of its first feed move
  std::size_t line = 0; ///< where it begins
  std::size_t feed_moves = 0, rapid_moves = 0;
  double feed_length = 0, rapid_length = 0; ///< of moves known at both ends [mm]
  double volume = 0;                        ///< taken off the stock [mm3]
  double axial_depth =
      0; ///< thickest layer at once, see Verification::axial_depth [mm]
  std::size_t axial_line = 0; ///< where that is
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
  std::size_t unreachable_points = 0; ///< that are not `in_reach`
  /// Of the unreachable those that it would reach if there were no keep-out zones: what
  /// stays uncut because of them, and is in no residual.
  std::size_t kept_out_points = 0;
  std::size_t untouched_points = 0; ///< no tool passes over them
  /// @brief Share of the points that no tool passes over.
  double untouchedShare() const
  {
    return points > 0 ? double(untouched_points) / double(points) : 0.0;
  }
  /// @brief The measured points, in the order of the part's index, each with what the
  /// program leaves over it: cut surface minus point [mm], negative where it cuts into
  /// it, NaN where no tool passes.
  pcl::PointCloud<pcl::PointXYZI> deviations;
  /// @brief For each of them whether the last tool can reach it: the others are under
  /// its envelope, covered by points above them or kept out of by zones. All are, where
  /// no tool cuts.
  std::vector<bool> in_reach;
  /// @brief The deviations of the points in reach alone.
  pcl::PointCloud<pcl::PointXYZI> deviationsInReach() const;
  /// @brief Share of the deviations of points in reach that are at most @p tolerance;
  /// 0 where there are none.
  double shareWithin(double tolerance) const;

  std::size_t rapids_in_stock = 0;
  double rapid_depth = 0;                             ///< deepest of them [mm]
  Eigen::Vector3d rapid_at = Eigen::Vector3d::Zero(); ///< end of that move
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

  std::vector<SectionFigures> sections; ///< in the program's order

  CellCloud milled; ///< the stock after the program, an organised height field
  std::vector<Finding> findings; ///< errors first, else as findingCodes()

  /// @brief Whether there is no error. Warnings do not refuse a program.
  bool good() const
  {
    return findings.empty() || findings.front().severity != Severity::Error;
  }
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
  /// @brief What may be in the spindle. Flutes, shank and holder are looked at where
  /// their lengths are given.
  void setTools(std::vector<Tool> tools) { tools_ = std::move(tools); }
  /// @brief Warn where the tool of this number takes a thicker layer at once [mm].
  void setAxialLimit(int tool, double depth) { axial_limits_[tool] = depth; }
  /// @brief What the machine can do; what is not known of it is not checked.
  void setMachine(const Machine& machine) { machine_ = machine; }
  /// @brief Points that get deeper into a tool than this are gouged [mm].
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  /// @brief Refuse a program that leaves more than this over half of the points [mm].
  void setResidualLimit(double limit) { residual_limit_ = limit; }
  /// @brief Warn where a tenth of the points keep more than twice this, and the
  /// tolerance, of material: of a program that is known to be whole [mm].
  void setExpectedResidual(double p90) { expected_residual_ = p90; }
  /// @brief No tip is meant to go below this [mm]: what lies under it is not left over.
  void setFloor(double floor) { floor_ = floor; }
  /// @brief Steepest that a tool with a flat on its end may sink into material
  /// [degrees].
  void setRampLimit(double degrees) { ramp_limit_ = degrees; }
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
    v("ramp_limit",
      ramp_limit_,
      "deg",
      Range{0.1, 89},
      "steeper into material is a plunge, which a flat end cannot do");
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
  std::map<int, double> axial_limits_;
  Machine machine_;
  double expected_residual_ = std::numeric_limits<double>::infinity();
  double residual_limit_ = 1e4, cell_ = 0.25, ramp_limit_ = 45.0;
  double floor_ = -std::numeric_limits<double>::infinity();
  double blend_limit_ = std::numeric_limits<double>::infinity();
  unsigned threads_ = 0;
};

} // namespace pointmill
