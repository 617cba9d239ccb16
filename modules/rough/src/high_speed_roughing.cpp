// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "high_speed_plan.h"

#include <pointmill/rough/high_speed_roughing.h>

#include <cmath>

namespace pointmill {

namespace {
constexpr double kLeastStepOver = 0.03; // diameters of the tool's end
}

void HighSpeedRoughing::checkParameters() const
{
  LevelRoughing::checkParameters();
  validateParameters(*this, getName());
  const double least = kLeastStepOver * getTool().endDiameter();
  if (getStepOver() < least)
    throw ParameterError(getName() + ": a step-over of " +
                         std::to_string(getStepOver()) +
                         " mm is too fine to be measured; " + std::to_string(least) +
                         " mm is the least for this tool");
}

std::vector<LevelPath> HighSpeedRoughing::clearLevel(const Level& level,
                                                     Report& figures) const
{
  HighSpeedPlan plan(level,
                     {mode_ == MillingMode::Climb ? 1.0 : -1.0,
                      std::tan(ramp_angle_ * M_PI / 180.0),
                      stepDown()});
  auto paths = plan.clear();
  plan.report(figures);
  return paths;
}

std::vector<LevelPath> HighSpeedRoughing::clearRest(const Level&, Material&) const
{
  return {}; // what is left is narrow or a skin, and is reported
}

} // namespace pointmill
