// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/rough/level.h>
#include <pointmill/rough/material.h>
#include <pointmill/rough/narrow_place.h>
#include <pointmill/slice/z_slices.h>

#include <memory>
#include <vector>

namespace pointmill {

/// @brief Roughing level by level, from an occupancy map to the CL points of the
/// cutting passes: one pass (`label`) per connected path, `level` counted from 0 at the
/// top. Entries, links and retracts between the passes are LinkPasses' work. What a
/// strategy does within a level is its clearLevel().
///
/// All strategies work on one description of a level: where the tool leaves the
/// allowance on the part, less what is no stock any more. After the strategy, each
/// level gets passes along the border of the part where stock is left, so that no
/// ridges stay beside the walls; some strategies do without (clearRest()). Levels are
/// planned in parallel; the result does not depend on it.
class LevelRoughing : public Stage<PointCell, PointCL> {
public:
  using Stage<PointCell, PointCL>::Stage;

  void setTool(const Tool& tool) { tool_ = tool; }
  const Tool& getTool() const { return tool_; }
  /// @brief Material to leave on the part [mm].
  void setAllowance(double allowance) { allowance_ = allowance; }
  double getAllowance() const { return allowance_; }
  /// @brief Distance between levels [mm]; 0: paper 001's 0.3 d / 4.
  void setStepDown(double step) { step_down_ = step; }
  double getStepDown() const { return step_down_; }
  /// @brief The same, as it is used [mm].
  double stepDown() const
  {
    return step_down_ > 0 ? step_down_ : ZSlices::pitchForDiameter(tool_.endDiameter());
  }
  /// @brief Distance between neighbouring rows or contours [mm].
  void setStepOver(double step) { step_over_ = step; }
  double getStepOver() const { return step_over_; }
  /// @brief Level ground of at least this area [mm2] gets a level of its own, at most
  /// one between two others; 0: none.
  void setMinFlat(double area) { min_flat_ = area; }
  double getMinFlat() const { return min_flat_; }
  /// @brief Height of the last level [mm]; by default the lowest point of the map.
  void setFloor(double floor) { floor_ = floor; }
  /// @brief The stock as earlier operations left it; by default a block round the map.
  void setStock(std::shared_ptr<const StockField> stock) { stock_ = std::move(stock); }
  /// @brief Rest roughing: leave stock to later operations that stands less than
  /// @p thickness above what this tool would leave, or is a skin on a wall narrower
  /// than @p width [mm].
  void setRestLimits(double thickness, double width)
  {
    min_thickness_ = thickness;
    min_width_ = width;
  }
  double getMinThickness() const { return min_thickness_; }
  double getMinWidth() const { return min_width_; }
  /// @brief The part's points, with what bridges their gaps, for exact heights; without
  /// them the map's cells are what is kept clear of.
  void setPart(std::shared_ptr<const PointIndex> part) { part_ = std::move(part); }
  /// @brief Where no tool may be, clamps say.
  void setKeepOut(KeepOut zones) { keep_out_ = std::move(zones); }
  const KeepOut& getKeepOut() const { return keep_out_; }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  /// @brief Of the last run, the largest first.
  const std::vector<NarrowPlace>& getNarrowPlaces() const { return narrow_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("allowance", allowance_, "mm", Range{0, 20}, "material left on the part");
    v("step_down",
      step_down_,
      "mm",
      Range{0, 50},
      "distance between levels; 0: 0.3 d/4");
    v("step_over", step_over_, "mm", Range{0.05, 200}, "distance between rows");
    v("min_flat", min_flat_, "mm2", Range{0, 1e6}, "smallest flat with its own level");
    v("min_thickness", min_thickness_, "mm", Range{0, 50}, "thinner stock is left");
    v("min_width", min_width_, "mm", Range{0, 50}, "narrower stock is left");
  }

protected:
  void checkParameters() const override;
  void apply(CLCloud& output) override;

  /// @brief What clears that which is needed on @p level, in machining order. Called
  /// from many threads.
  /// @param figures added up over the levels, by name, into the report
  virtual std::vector<LevelPath> clearLevel(const Level& level,
                                            Report& figures) const = 0;
  /// @brief What clears that which the strategy left: @p material as it stands then.
  virtual std::vector<LevelPath> clearRest(const Level& level,
                                           Material& material) const;

private:
  Tool tool_ = Tool::flat(1, 10.0);
  double allowance_ = 0.5, step_down_ = 0.0, step_over_ = 4.0, min_flat_ = 0.0;
  double min_thickness_ = 0.0, min_width_ = 0.0;
  double floor_ = std::numeric_limits<double>::quiet_NaN();
  std::shared_ptr<const StockField> stock_;
  std::shared_ptr<const PointIndex> part_;
  KeepOut keep_out_;
  unsigned threads_ = 0;
  std::vector<NarrowPlace> narrow_;
};

} // namespace pointmill
