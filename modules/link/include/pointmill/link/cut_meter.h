// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/tool.h>
#include <pointmill/surface/stock_field.h>

#include <Eigen/Core>

#include <deque>

namespace pointmill {

/// @brief What the feed moves of a path take from the stock, and how hard the tool is
/// engaged. Layers thinner than Cut::kSwarf have no width.
struct CutFigures {
  double volume = 0;          ///< [mm3]
  double material_length = 0; ///< of feed moves that cut [mm]
  double air_length = 0;      ///< of feed moves that do not [mm]
  /// Thickest layer that the tool takes at once, if it goes on level [mm], splinters
  /// not counted, so an upper
  /// figure where it climbs over what it begins to cut. Going down steeply, what it
  /// takes in a quarter of the end's diameter.
  double max_axial = 0;
  /// Width of the cut, the area that is cut per length [mm], at most the diameter:
  /// the largest over any quarter of the end's diameter of way, and the mean in
  /// material. Plunges and ramps, which cut with the whole end, do not count.
  double max_radial = 0, mean_radial = 0;

  /// @brief Share of the feed moves' length that cuts nothing.
  double airShare() const
  {
    const double length = material_length + air_length;
    return length > 0 ? air_length / length : 0.0;
  }
};

/// @brief Cuts a stock along a path, in pieces of a quarter of the end's diameter, and
/// measures what they take. With cells of edge c a radial engagement is right to some
/// c, at worst to the rows of cells that the front and the flanks of a piece touch.
class CutMeter {
public:
  /// @param stock of nominal heights; it is cut and must outlive the meter
  CutMeter(const Tool& tool, StockField& stock);

  /// @brief Makes a feed move.
  /// @return the largest cross-section of what it takes [mm2], over a quarter of the
  /// end's diameter
  double cut(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Motion motion);
  /// @brief The tool leaves the stock: what comes next is not beside what was.
  void lift() { window_.clear(); }

  const CutFigures& figures() const { return figures_; }

private:
  struct Piece {
    double length, run, area, volume, axial; // run: in XY
  };
  double add(const Piece& piece, bool entry);

  Tool tool_;
  StockField& stock_;
  double reach_;
  std::deque<Piece> window_; // the last pieces, together as long as the reach
  bool entry_ = false;       // whether they are of an entry
  double area_ = 0, run_ = 0;
  CutFigures figures_;
};

/// @brief The figures of a whole path, cut from @p stock (nominal heights).
CutFigures measureCut(const CLCloud& path, const Tool& tool, StockField& stock);

} // namespace pointmill
