// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/operation.h>
#include <pointmill/common/stage.h>
#include <pointmill/link/cut_meter.h>
#include <pointmill/link/path_figures.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/stock_field.h>

#include <memory>

namespace pointmill {

/// @brief Joins passes (`label`) in their order into the complete path of one
/// operation: approach, entry, pass, link or retract, back to the clearance plane.
/// Feeds are set on the way. A pass keeps the motions that it comes with.
///
/// - Entries into material come level from outside, else on a helix, else on a ramp
///   along the pass, else straight down. A tool with a flat on its end (flat, bull
///   nose) may not cut at its centre: passes that it would have to enter straight down
///   are left out ("skipped" in the report) for a later tool.
/// - Between two passes the tool takes the quickest way that is proven clear of the
///   part and of stock: at feed from pass to pass, lifted just enough, or over the
///   clearance plane. Rapids never meet standing stock, in whatever order the machine
///   moves its axes.
/// - Level passes may be entered and left on arcs.
/// - Descending feed moves are slowed so that the tool never goes down faster than its
///   plunge feed, except straight down through what the nominal stock proves to be air.
///   Where a move takes more than a tenth of the diameter squared as cross-section, its
///   feed falls in proportion.
///
/// The stock is cut along, so that the next operation knows what stands.
class LinkPasses : public Filter<PointCL> {
public:
  LinkPasses() : Filter<PointCL>("LinkPasses") {}

  void setTool(const Tool& tool) { tool_ = tool; }
  void setCutting(const Cutting& cutting) { cutting_ = cutting; }
  /// @brief Where sideways rapids always may run [mm]; must be above the stock and all
  /// zones that are kept out of.
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
  /// @brief Greatest radius of a helical entry, as a share of the end's diameter; less
  /// where there is no room, half of it at least. 0: no helices.
  void setHelixRadius(double share) { helix_radius_ = share; }
  double getHelixRadius() const { return helix_radius_; }
  /// @brief Radius of the arcs on which level passes are entered and left [mm]; 0:
  /// none.
  void setLeadRadius(double radius) { lead_radius_ = radius; }
  double getLeadRadius() const { return lead_radius_; }
  /// @brief Feeds come in steps of at most this share, down from the full feed and the
  /// plunge feed, so that few moves change them; none is raised. 0: each move has its
  /// own.
  void setFeedStep(double share) { feed_step_ = share; }
  double getFeedStep() const { return feed_step_; }
  /// @brief How fast rapids are taken to be [mm/min], to choose the quickest way.
  void setRapidRate(double rate) { rapid_rate_ = rate; }
  double getRapidRate() const { return rapid_rate_; }
  /// @brief Whether rapids may run sideways below the clearance plane, where nothing
  /// stands in the whole box that a dog-legging machine may sweep. Without them such
  /// ways are straight feed moves.
  void setLowRapids(bool allowed) { low_rapids_ = allowed; }
  bool getLowRapids() const { return low_rapids_; }
  /// @brief The stock, an upper bound; it is cut along the path.
  void setStock(std::shared_ptr<StockField> stock) { stock_ = std::move(stock); }
  /// @brief The same stock with nominal heights, cut along too: it tells how much each
  /// move takes, for its feed and the figures. Without it feeds do not fall in heavy
  /// cuts.
  void setNominalStock(std::shared_ptr<StockField> stock)
  {
    nominal_ = std::move(stock);
  }
  /// @brief The part; without it there are no links, lifts, arcs and helices, and no
  /// entries from outside.
  void setPart(std::shared_ptr<const PointIndex> part, double allowance, double floor)
  {
    part_ = std::move(part);
    allowance_ = allowance;
    floor_ = floor;
  }
  /// @brief Where no tool may be: links, lifts, entries, arcs and rapids keep clear of
  /// it. What the passes do is theirs.
  void setKeepOut(KeepOut zones) { keep_out_ = std::move(zones); }

  /// @brief What the last run cut; zeros without a nominal stock.
  const CutFigures& getCutFigures() const { return cut_; }

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
    v("helix_radius",
      helix_radius_,
      "",
      Range{0, 0.5},
      "greatest radius of helical entries over the end's diameter");
    v("lead_radius", lead_radius_, "mm", Range{0, 50}, "arcs into and out of passes");
    v("feed_step", feed_step_, "", Range{0, 0.5}, "largest share between two feeds");
    v("rapid_rate", rapid_rate_, "mm/min", Range{1, 1e6}, "speed of rapids");
  }

protected:
  void checkParameters() const override;
  void apply(CLCloud& output) override;

private:
  Tool tool_ = Tool::flat(1, 10.0);
  Cutting cutting_;
  double clearance_ = std::numeric_limits<double>::quiet_NaN();
  double approach_ = 1.0, ramp_angle_ = 3.0, stay_down_ = 0.0;
  double helix_radius_ = 0.45, lead_radius_ = 0.0, rapid_rate_ = 5000.0;
  double feed_step_ = 0.05;
  bool low_rapids_ = false;
  std::shared_ptr<StockField> stock_, nominal_;
  std::shared_ptr<const PointIndex> part_;
  double allowance_ = 0.0, floor_ = -std::numeric_limits<double>::infinity();
  KeepOut keep_out_;
  CutFigures cut_;
};

} // namespace pointmill
