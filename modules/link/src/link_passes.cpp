// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "feed_steps.h"
#include "pass_linker.h"

#include <pointmill/link/link_passes.h>

#include <string>

namespace pointmill {
namespace {

void checkPoint(const PointCL& p, bool first, int number, double clearance)
{
  const auto refuse = [&](const char* why) {
    throw DataError("LinkPasses: CL point " + std::to_string(number) + " " + why);
  };
  if (!position(p).allFinite())
    refuse("is not finite");
  if (p.z > clearance)
    refuse("lies above the clearance plane");
  if (!first && isRapid(p.getMotion()))
    refuse("is a rapid within a pass");
}

} // namespace

void LinkPasses::checkParameters() const
{
  validateParameters(*this, getName());
  tool_.validate();
  checkRange(getName(), "feed", cutting_.feed, "mm/min", {1, 1e5});
  checkRange(getName(), "plunge_feed", cutting_.plunge_feed, "mm/min", {1, 1e5});
  if (stock_ && !(clearance_ > stock_->stock().top()))
    throw ParameterError("LinkPasses: the clearance plane is not above the stock");
}

void LinkPasses::apply(CLCloud& output)
{
  std::vector<PlannedPass> passes;
  for (const auto i : *indices_) { // all of them, before the stock is cut
    const PointCL& p = (*input_)[i];
    const bool first = passes.empty() || passes.back().points.back()->label != p.label;
    checkPoint(p, first, i, clearance_);
    if (first)
      passes.emplace_back();
    passes.back().points.push_back(&p);
    passes.back().way.push_back(position(p));
  }

  PathBuilder path(tool_, cutting_, stock_.get(), nominal_.get(), output);
  const Surroundings around{tool_,
                            clearance_,
                            approach_,
                            stock_.get(),
                            nominal_.get(),
                            part_.get(),
                            allowance_,
                            floor_,
                            keep_out_};
  const Entries entries(around, ramp_angle_, helix_radius_);
  const LeadArcs arcs(around, lead_radius_);
  const Transitions transitions(
      around, entries, cutting_, rapid_rate_, stay_down_, low_rapids_);
  PassLinker linker(path, around, entries, arcs, transitions);
  const WorkStep all({0.0, 1.0});
  for (std::size_t k = 0; k < passes.size(); ++k) {
    all.reach(double(k) / double(passes.size()));
    linker.add(passes[k]);
  }
  linker.finish();
  cut_ = path.figures();
  if (feed_step_ > 0)
    stepFeeds(output, cutting_, feed_step_);

  const auto set = [&](const char* name, auto value) {
    report_.set(name, static_cast<double>(value));
  };
  const auto& tally = linker.tally();
  set("skipped", tally.skipped);
  set("passes", tally.passes);
  set("links", tally.links);
  set("lifts", tally.lifts);
  set("retracts", tally.retracts);
  set("outside", tally.outside);
  set("helices", tally.helices);
  set("ramps", tally.ramps);
  set("plunges", tally.plunges);
  set("lead_ins", tally.lead_ins);
  set("lead_outs", tally.lead_outs);
  if (!nominal_)
    return;
  set("link_volume_mm3", path.linkVolume());
  set("volume_mm3", cut_.volume);
  set("material_mm", cut_.material_length);
  set("air_mm", cut_.air_length);
  set("axial_max_mm", cut_.max_axial);
  set("radial_max_mm", cut_.max_radial);
  set("radial_mean_mm", cut_.mean_radial);
}

} // namespace pointmill
