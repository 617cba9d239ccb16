// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/milling_mode.h>
#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief Constant engagement: the step-over is the largest width of cut, measured as
/// area cut per length on the stock as it stands, and the tool is steered along so that
/// it is kept. There are no full-width cuts but on entries down a helix, or, where the
/// part leaves no room, on ramps forth and back.
///
/// The tool begins from outside the stock or on ground that is clear already. Where a
/// walk has lost its material the tool stays down and goes over clear ground to the
/// next one (`Motion::Link`).
class HighSpeedRoughing : public LevelRoughing {
public:
  HighSpeedRoughing() : LevelRoughing("HighSpeedRoughing") {}

  /// @brief Steepest helix or ramp into material [degrees].
  void setRampAngle(double degrees) { ramp_angle_ = degrees; }
  double getRampAngle() const { return ramp_angle_; }
  /// @brief On which side of the tool the material is; it turns clockwise (M3).
  void setMillingMode(MillingMode mode) { mode_ = mode; }
  MillingMode getMillingMode() const { return mode_; }

  template <typename V>
  void parameters(V&& v)
  {
    LevelRoughing::parameters(v);
    v("ramp_angle", ramp_angle_, "deg", Range{0.1, 45}, "steepest way into material");
  }

protected:
  void checkParameters() const override;
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;

private:
  double ramp_angle_ = 3.0;
  MillingMode mode_ = MillingMode::Climb;
};

} // namespace pointmill
