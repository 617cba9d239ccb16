// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/mill/mill_options.h>
#include <pointmill/slice/z_slices.h>

#include <cmath>

namespace pointmill {

double MillOptions::stepDown() const
{
  return step_down > 0 ? step_down
                       : ZSlices::pitchForDiameter(rough.tool.endDiameter());
}

double MillOptions::stepOver() const
{
  return step_over > 0 ? step_over : kRoughStepOver * rough.tool.endDiameter();
}

void MillOptions::validate() const
{
  const std::string who = "mill";
  checkRange(who, "--tolerance", tolerance, "mm", {0.002, 1});
  checkRange(who, "--scallop", scallop, "mm", {0.0005, 1});
  checkRange(who, "--semi-scallop", semi_scallop, "mm", {0.0005, 2});
  checkRange(who, "--cell", cell, "mm", {0, 20});
  checkRange(who, "--clearance", clearance, "mm", {0.5, 500});
  machine.validate();
  checkRange(who, "--stock-margin", stock_margin, "mm", {0, 500});
  checkRange(who, "--stock-top", stock_top, "mm", {0, 500});
  checkRange(who, "--stock-bottom", stock_bottom, "mm", {0, 500});
  if (stock_box && !((stock_box->max - stock_box->min).minCoeff() > 0))
    throw ParameterError(who + ": --stock-box has no volume: X0 Y0 Z0 X1 Y1 Z1");
  if (!stock_scan.empty() + stock_box.has_value() +
          (stock_margin > 0 || stock_top > 0 || stock_bottom > 0) >
      1)
    throw ParameterError(who + ": --stock-box, --stock-scan and the margins of the "
                               "stock exclude each other");
  checkRange(who, "--step-down", step_down, "mm", {0, rough.tool.diameter});
  checkRange(who, "--step-over", step_over, "mm", {0, rough.tool.endDiameter()});
  checkRange(who, "--overhang", overhang, "mm", {-100, 100});
  if (!std::isnan(noise))
    checkRange(who, "--noise", noise, "mm", {0, 10});
  if (over_stock && !boundary.empty())
    throw ParameterError(who + ": --boundary stock and --polygon exclude each other");
  if (overhang != 0 && !over_stock && boundary.empty())
    throw ParameterError(who + ": --overhang needs --boundary stock or --polygon");
  if (milling == MillingMode::Conventional && pattern != RasterPattern::OneWay)
    throw ParameterError(who + ": --milling needs --pattern one-way");
  double twice = 0; // the polygon's area
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Eigen::Vector2d &a = boundary[i], &b = boundary[(i + 1) % boundary.size()];
    if (!a.allFinite())
      throw ParameterError(who + ": --polygon has a corner that is not finite");
    twice += a.x() * b.y() - a.y() * b.x();
  }
  if (!boundary.empty() && std::abs(twice) < 1e-3)
    throw ParameterError(who + ": --polygon encloses no area");
  checkRange(who, "--residual-limit", residual_limit, "mm", {0.001, 1000});
  checkRange(who, "--fit", fit, "mm", {0, 3000});
  checkRange(who, "--units/--scale", mm_per_unit, "mm per unit", {1e-6, 1e6});
  if (!std::isnan(min_flat))
    checkRange(who, "--min-flat", min_flat, "mm2", {0, 1e6});
  std::vector<const ToolJob*> jobs{&rough, &semi, &finish};
  if (rest)
    jobs.push_back(&*rest);
  for (const auto* job : jobs) {
    job->tool.validate();
    const std::string tool = who + ": " + job->tool.describe();
    checkRange(tool, "spindle", job->cutting.spindle, "rpm", {1, 200000});
    if (machine.max_spindle > 0)
      checkRange(tool,
                 "spindle",
                 job->cutting.spindle,
                 "rpm",
                 {machine.min_spindle, machine.max_spindle});
    checkRange(tool, "feed", job->cutting.feed, "mm/min", {1, 50000});
    checkRange(tool, "plunge feed", job->cutting.plunge_feed, "mm/min", {1, 50000});
    checkRange(tool, "allowance", job->allowance, "mm", {0, 20});
  }
  for (const auto* job : {&semi, &finish})
    if (job->tool.corner_radius <= 0)
      throw ParameterError(who + ": " + job->tool.describe() +
                           " has no round to work a step-over out from a scallop: "
                           "finish with a ball, a bull or a taper");
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (jobs[i]->tool.number == jobs[k]->tool.number)
        throw ParameterError(who + ": two tools have one number");
  writer.getPost().validate();
  if (rest && rest->tool.diameter >= rough.tool.diameter)
    throw ParameterError(who + ": --rest-tool is no smaller than the roughing tool");
}

ErrorBudget ErrorBudget::of(double tolerance)
{
  return {0.225 * tolerance, 0.225 * tolerance, 0.5 * tolerance, 0.05 * tolerance};
}

} // namespace pointmill
