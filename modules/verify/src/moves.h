// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

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
  Bands(const std::vector<SweptMove>& moves, double y0, double height, int count);

  int count() const { return static_cast<int>(bands_.size()); }
  const std::vector<std::uint32_t>& operator[](std::size_t band) const
  {
    return bands_[band];
  }

private:
  std::vector<std::vector<std::uint32_t>> bands_;
};

/// @brief Checks what can be said of every move alone, counts and measures, and returns
/// those that can be swept.
/// @param safe what moves from or to unknown places must stay above [mm]
std::vector<SweptMove> collectMoves(const Program& program,
                                    const std::vector<Tool>& tools,
                                    const Stock& stock,
                                    double safe,
                                    Verification& result);

/// @brief How deep the points of an index get inside the tools.
struct Gouges {
  double depth = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  std::size_t line = 0;
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
                 Verification& result);

/// @brief How deep the moves get into zones where no tool may be.
void judgeKeepOut(const KeepOut& keep_out,
                  const std::vector<SweptMove>& moves,
                  double tolerance,
                  unsigned threads,
                  Verification& result);

/// @brief Cuts the stock in the program's order; rapids that cut are findings.
/// @param field the stock, with nominal heights
void judgeStock(StockField field,
                const std::vector<SweptMove>& moves,
                double tolerance,
                unsigned threads,
                Verification& result);

} // namespace pointmill
