// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "findings.h"

#include <pointmill/surface/stock_field.h>
#include <pointmill/verify/program_verifier.h>

#include <functional>
#include <vector>

namespace pointmill {

/// @brief A move of the program that is known at both ends, with its tool.
struct SweptMove {
  Eigen::Vector3d a, b;
  const Tool* tool;
  std::size_t line;
  bool rapid;
  std::uint32_t section = 0; ///< of Verification::sections

  /// Whether the tip may leave the straight line: the axes of a rapid need not arrive
  /// at once. It then stays in the box of the move's ends (a dog-leg).
  bool mayBend() const
  {
    const Eigen::Vector3d way = b - a;
    return rapid && (way.array() != 0).count() > 1;
  }
};

/// @brief Deals moves to horizontal bands of the plane, so that threads can work
/// through the bands on their own and each still meets its moves in the program's
/// order.
class Bands {
public:
  /// @param y0 lower border of band 0; @param height of a band [mm]
  Bands(double y0, double height, int count);

  /// @brief Adds number @p id, which matters between @p ya and @p yb and @p reach [mm]
  /// beyond.
  void add(std::size_t id, double ya, double yb, double reach);

  int count() const { return static_cast<int>(bands_.size()); }
  const std::vector<std::uint32_t>& operator[](std::size_t band) const
  {
    return bands_[band];
  }

private:
  double y0_, height_;
  std::vector<std::vector<std::uint32_t>> bands_;
};

/// @brief Where the sections of a program begin, in the order of the moves; the first
/// with the first move. Each has one tool that cuts: one that the program does not part
/// by tools is parted here.
std::vector<ProgramSection> sectionsOf(const Program& program);

/// @brief What the moves are checked against one by one.
struct MoveLimits {
  const Stock& stock;
  const Machine& machine;
  double safe;      ///< what moves from or to unknown places must stay above [mm]
  double tolerance; ///< a feed move may sink so deep below the stock [mm]
};

/// @brief Checks what can be said of every move alone and of each in a row, counts and
/// measures, and returns those that can be swept.
std::vector<SweptMove> collectMoves(const Program& program,
                                    const std::vector<Tool>& tools,
                                    const MoveLimits& limits,
                                    Verification& result,
                                    Findings& findings);

/// @brief How deep the points of an index get inside the tools.
struct Gouges {
  double depth = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  std::size_t line = 0;
  int tool = 0;
  std::size_t count = 0; ///< of the points deeper than the tolerance
};

/// @brief Sweeps the moves over points. Of equally deep gouges the first in the program
/// is named.
/// @param height lowest height of any tool over each point; infinite where none comes
/// by
Gouges sweepPoints(const PointIndex& points,
                   const std::vector<SweptMove>& moves,
                   double tolerance,
                   unsigned threads,
                   std::vector<float>& height);

/// @brief What points may suffer [mm].
struct PointLimits {
  double tolerance; ///< deepest gouge
  double noise;     ///< so much more for points as they were measured
  double floor;     ///< a perfect pass, too, goes no lower
};

/// @brief Gouges, residuals and deviations at the points of the surface; gouges and
/// deviations at the measured points @p raw as well, unless that is null.
void judgePoints(const PointIndex& surface,
                 const PointIndex* raw,
                 const std::vector<SweptMove>& moves,
                 const PointLimits& limits,
                 const KeepOut& keep_out,
                 unsigned threads,
                 Verification& result,
                 Findings& findings);

/// @brief Rapids that may bend into points of the part; those that run straight into
/// them are gouges.
void judgeBends(const PointIndex& part,
                const std::vector<SweptMove>& moves,
                double tolerance,
                unsigned threads,
                Findings& findings);

/// @brief How deep the moves get into zones where no tool may be.
void judgeKeepOut(const KeepOut& keep_out,
                  const std::vector<SweptMove>& moves,
                  double tolerance,
                  unsigned threads,
                  Verification& result,
                  Findings& findings);

/// @brief What the tools may do in the stock.
struct StockLimits {
  double tolerance;  ///< rapids, shanks and holders may touch so deep [mm]
  double ramp_slope; ///< steeper is a plunge: descent over way in XY
  const std::map<int, double>& axial; ///< thickest layer, by tool [mm]
};

/// @brief Cuts the stock in the program's order; what a tool must not do in it are
/// findings.
/// @param field the stock, with nominal heights
void judgeStock(StockField field,
                const std::vector<SweptMove>& moves,
                const StockLimits& limits,
                unsigned threads,
                Verification& result,
                Findings& findings);

/// @brief Shanks and holders against the points of the part; against the stock see
/// judgeStock().
void judgeBodies(const PointIndex& part,
                 const std::vector<SweptMove>& moves,
                 double tolerance,
                 unsigned threads,
                 Findings& findings);

} // namespace pointmill
