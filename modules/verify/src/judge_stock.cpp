// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "layer_gauge.h"
#include "moves.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/stock_field.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr int kRowsPerBand = 8;
/// What a tool takes at once is what it takes on this share of its diameter.
constexpr double kPiece = 0.25;
/// A rapid that meets less is none in stock [mm].
constexpr double kMeets = 0.01;

/// A rapid may touch what it does not enter: what of the tool lies deeper than e
/// inside.
Tool shrunk(const Tool& tool, double e)
{
  Tool small = tool;
  small.diameter = std::max(0.0, tool.diameter - 2 * e);
  small.corner_radius = std::max(0.0, tool.corner_radius - e);
  small.tip_diameter = std::max(0.0, tool.tip_diameter - 2 * e);
  return small;
}

/// Cuts the moves into the rows of one band.
class BandCutter {
public:
  BandCutter(StockField& field, int row0, int row1, double tolerance)
      : field_(field), row0_(row0), row1_(row1), up_(0, 0, tolerance)
  {
  }

  /// How deep a rapid gets into the stock.
  double rapid(const SweptMove& m, const Tool& tool)
  {
    double depth = 0;
    const Vector3d low = m.a.cwiseMin(m.b) + up_;
    if (m.mayBend() && low.z() < field_.stock().top())
      depth = field_.depthIn(tool, low, m.a.cwiseMax(m.b) + up_, row0_, row1_);
    return std::max(depth, field_.cut(tool, m.a + up_, m.b + up_, row0_, row1_).depth);
  }

  /// A feed move, in pieces where it is long; short ones that follow each other make up
  /// one piece.
  void feed(const SweptMove& m)
  {
    const double longest = kPiece * m.tool->diameter;
    const double r = m.tool->radius() + field_.cellSize();
    const double bottom = field_.y(row0_) - r, top = field_.y(row1_ - 1) + r;
    const double length = (m.b - m.a).norm();
    const double count = std::max(1.0, std::ceil(length / longest));
    Vector3d from = m.a;
    for (double k = 1; k <= count; ++k) {
      const Vector3d to = k < count ? m.a + (k / count) * (m.b - m.a) : m.b;
      if (std::max(from.y(), to.y()) > bottom && std::min(from.y(), to.y()) < top) {
        if (piece_.tool != m.tool || piece_.end != from ||
            piece_.length + length / count > longest)
          endPiece();
        piece_.tool = m.tool;
        piece_.end = to;
        piece_.length += length / count;
        piece_.most +=
            field_.cut(*m.tool, from, to, row0_, row1_, &piece_.lowered).depth;
      }
      from = to;
    }
  }
  void endPiece()
  {
    if (piece_.tool) {
      double& thickest = axial_[piece_.tool->number];
      if (piece_.most > thickest)
        thickest = std::max(
            thickest,
            gauge_.thickness(piece_.lowered, piece_.tool->diameter, field_.cellSize()));
    }
    piece_.tool = nullptr;
    piece_.length = piece_.most = 0;
    piece_.lowered.clear();
  }

  /// The thickest layer that each tool takes at once, in the pieces that have ended.
  const std::map<int, double>& axial() const { return axial_; }

private:
  using Vector3d = Eigen::Vector3d;
  /// What was cut on a short way.
  struct Piece {
    const Tool* tool = nullptr;
    Vector3d end = Vector3d::Zero();
    double length = 0, most = 0; // most: no layer is thicker
    std::vector<LoweredCell> lowered;
  };

  StockField& field_;
  int row0_, row1_;
  Vector3d up_; // a rapid may touch the stock
  Piece piece_;
  LayerGauge gauge_;
  std::map<int, double> axial_;
};

} // namespace

void judgeStock(StockField field,
                const std::vector<SweptMove>& moves,
                double tolerance,
                unsigned threads,
                Verification& result)
{
  const int count = (field.rows() + kRowsPerBand - 1) / kRowsPerBand;
  const Bands bands(
      moves, field.stock().min.y(), kRowsPerBand * field.cellSize(), count);
  std::map<const Tool*, Tool> rapid_tools;
  for (const auto& m : moves)
    rapid_tools.emplace(m.tool, shrunk(*m.tool, tolerance));

  struct Outcome {
    std::map<std::size_t, double> rapids; // move -> depth
    std::map<int, double> axial;
  };
  std::vector<Outcome> outcomes(static_cast<std::size_t>(count));
  parallelFor(outcomes.size(), threads, [&](std::size_t band) {
    const int row0 = static_cast<int>(band) * kRowsPerBand;
    const int row1 = std::min(field.rows(), row0 + kRowsPerBand);
    Outcome& mine = outcomes[band];
    BandCutter cutter(field, row0, row1, tolerance);
    for (const auto k : bands[band]) {
      const SweptMove& m = moves[k];
      if (m.rapid) {
        const double depth = cutter.rapid(m, rapid_tools.at(m.tool));
        if (depth > kMeets)
          mine.rapids[k] = depth;
      }
      else {
        cutter.feed(m);
      }
    }
    cutter.endPiece();
    mine.axial = cutter.axial();
  });

  std::map<std::size_t, double> rapids;
  for (const auto& o : outcomes) {
    for (const auto& [k, depth] : o.rapids)
      rapids[k] = std::max(rapids[k], depth);
    for (const auto& [tool, depth] : o.axial)
      result.axial_depth[tool] = std::max(result.axial_depth[tool], depth);
  }
  result.rapids_in_stock = rapids.size();
  for (const auto& [k, depth] : rapids)
    if (depth > result.rapid_depth) {
      result.rapid_depth = depth;
      result.rapid_line = moves[k].line;
    }
  result.milled = field.toCloud();
}

} // namespace pointmill
