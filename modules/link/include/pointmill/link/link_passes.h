// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/common/stage.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/stock_field.h>

#include <memory>

namespace pointmill {

/// @brief Joins cutting passes (`label`) in their order into the complete path of one
/// operation: approach, entry, pass, link or retract, back to the clearance plane.
/// Feeds are set on the way.
///
/// - Sideways rapids run on the clearance plane only. Rapids down end above what still
///   stands of the stock under the whole cutter.
/// - An entry into material ramps down along the pass itself at the ramp angle; a pass
/// too
///   short for that is entered straight down at plunge feed.
/// - Two passes are linked at feed where their ends are near and the level move between
///   them is proven clear of the part and (almost) of stock; otherwise over the
///   clearance plane.
/// - Descending feed moves are slowed so that the tool never goes down faster than its
///   plunge feed, except through what the nominal stock proves to be air.
///
/// - Where a move takes more than a tenth of the diameter squared as cross-section, its
///   feed falls in proportion.
/// - A tool with a flat on its end (flat, bull nose) may not cut at its centre: passes
///   that it would have to enter straight down are left out ("skipped" in the report)
///   for a later tool.
///
/// The stock is cut along, so that the next operation knows what stands.
class LinkPasses : public Filter<PointCL> {
public:
  LinkPasses() : Filter<PointCL>("LinkPasses") {}

  void setTool(const Tool& tool) { tool_ = tool; }
  void setCutting(const Cutting& cutting) { cutting_ = cutting; }
  /// @brief Height of sideways rapids [mm]; must be above the stock.
  void setClearancePlane(double z) { clearance_ = z; }
  double getClearancePlane() const { return clearance_; }
  /// @brief Rapids down stop this far above the stock [mm].
  void setApproach(double approach) { approach_ = approach; }
  double getApproach() const { return approach_; }
  /// @brief Steepest ramp into material [degrees].
  void setRampAngle(double degrees) { ramp_angle_ = degrees; }
  double getRampAngle() const { return ramp_angle_; }
  /// @brief Passes whose ends are at most this far apart may be linked at feed [mm].
  void setStayDown(double distance) { stay_down_ = distance; }
  double getStayDown() const { return stay_down_; }
  /// @brief The stock, an upper bound; it is cut along the path.
  void setStock(std::shared_ptr<StockField> stock) { stock_ = std::move(stock); }
  /// @brief The same stock with nominal heights, cut along too: it tells how much each
  /// move takes, for its feed. Without it feeds do not fall in heavy cuts.
  void setNominalStock(std::shared_ptr<StockField> stock)
  {
    nominal_ = std::move(stock);
  }
  /// @brief The part, for links that stay down; without it there are none.
  void setPart(std::shared_ptr<const PointIndex> part, double allowance, double floor)
  {
    part_ = std::move(part);
    allowance_ = allowance;
    floor_ = floor;
  }

  template <typename V>
  void parameters(V&& v)
  {
    v("clearance_plane",
      clearance_,
      "mm",
      Range{-1e5, 1e5},
      "height of sideways rapids");
    v("approach",
      approach_,
      "mm",
      Range{0.1, 50},
      "rapids down stop so far above stock");
    v("ramp_angle", ramp_angle_, "deg", Range{0.1, 45}, "steepest ramp into material");
    v("stay_down", stay_down_, "mm", Range{0, 100}, "longest link at feed");
  }

protected:
  void checkParameters() const override;
  void apply(CLCloud& output) override;

private:
  /// Radius within which a pass over a place has certainly cut.
  double certainRadius() const;
  /// Highest stock within a radius of a move.
  double
  highest(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius) const;
  /// Height of a level feed move between two passes; the clearance plane for none.
  double linkHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  Tool tool_ = Tool::flat(1, 10.0);
  Cutting cutting_;
  double clearance_ = std::numeric_limits<double>::quiet_NaN();
  double approach_ = 1.0, ramp_angle_ = 3.0, stay_down_ = 0.0;
  std::shared_ptr<StockField> stock_, nominal_;
  std::shared_ptr<const PointIndex> part_;
  double allowance_ = 0.0, floor_ = -std::numeric_limits<double>::infinity();
};

/// @brief Lengths and time of a path.
struct PathFigures {
  std::size_t cl_points = 0, passes = 0, retracts = 0;
  double cutting_length = 0; ///< feed moves, mm
  double rapid_length = 0;   ///< mm
  double minutes = 0;        ///< feed moves at their feed, rapids at the rapid rate
};

/// @param rapid_rate mm/min
PathFigures measurePath(const CLCloud& path, double rapid_rate);

} // namespace pointmill
