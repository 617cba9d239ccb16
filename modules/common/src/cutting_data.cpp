// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/cutting_data.h>
#include <pointmill/common/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// The edge of a tool that is engaged over a depth of cut.
struct Edge {
  double diameter;  ///< of the cut at its top [mm]
  double sine;      ///< of the entering angle there, where chips are thickest
  double mean_sine; ///< along the edge: the depth by the edge's length
};

/// From CutterProfile's outline: a rounding up to the height `round`, a cone above it,
/// and above that the cylinder.
Edge edgeOf(const Tool& tool, double depth)
{
  const double taper = tool.taper * kPi / 180, c = tool.corner_radius,
               flat = tool.flatRadius(), round = c * (1 - std::sin(taper));
  if (depth < round) {
    const double sine = std::sqrt(depth * (2 * c - depth)) / c;
    return {2 * (flat + c * sine), sine, depth / (c * std::acos(1 - depth / c))};
  }
  const double from = flat + c * std::cos(taper); // the radius where the cone begins
  const double cone = tool.isTapered() ? (tool.radius() - from) / std::tan(taper)
                                       : std::numeric_limits<double>::infinity();
  const double up = std::min(depth - round, cone);
  const double length =
      c * (kPi / 2 - taper) + up / std::cos(taper) + (depth - round - up);
  return {2 * (from + up * std::tan(taper)),
          depth - round > cone ? 1.0 : std::cos(taper),
          depth / length};
}

/// The thickest chip by that of a slot: less than 1 where the tool is engaged over less
/// than its radius.
double radialThinning(double width, double diameter)
{
  const double share = std::min(width / diameter, 0.5);
  return 2 * std::sqrt(share * (1 - share));
}

/// Mean chip by feed per tooth along the arc of engagement.
double radialMean(double width, double diameter)
{
  const double share = std::min(width / diameter, 1.0);
  return 2 * share / std::acos(1 - 2 * share);
}

double defaultDepth(const CutSetting& cut)
{
  const double end = cut.tool.endDiameter();
  const double depth = cut.kind == CutKind::Roughing ? cut.material.rough_depth * end
                       : cut.tool.corner_radius > 0  ? 0.05 * end
                                                     : 0.5 * end;
  return cut.tool.flute_length > 0 ? std::min(depth, cut.tool.flute_length) : depth;
}

double defaultWidth(const CutSetting& cut, double diameter)
{
  return cut.kind == CutKind::Roughing
             ? 0.4 * diameter
             : std::min(0.05 * cut.tool.endDiameter(), diameter);
}

double defaultSpeed(const CutSetting& cut)
{
  const bool hss = cut.tool_material == ToolMaterial::Hss;
  const Range& range = hss ? cut.material.hss_speed : cut.material.carbide_speed;
  const double speed = cut.kind == CutKind::Roughing ? range.low : range.high;
  if (hss && !(speed > 0))
    throw ParameterError("cutting: " + cut.material.name +
                         " is not to be milled with high-speed steel");
  return speed;
}

/// What was given, or follows from the material; checked.
CuttingData asked(const CutSetting& cut)
{
  const std::string who = "cutting";
  const Tool& tool = cut.tool;
  const double end = tool.endDiameter();
  const auto length = [&](const char* name, double value, double most) {
    checkRange(who, name, value, "mm", {1e-4, most});
    return value;
  };
  CuttingData data;
  data.depth = length("depth of cut",
                      cut.depth.value_or(defaultDepth(cut)),
                      tool.flute_length > 0 ? tool.flute_length : 5 * tool.diameter);
  data.effective_diameter = edgeOf(tool, data.depth).diameter;
  const double widest = data.effective_diameter * (1 + 1e-12); // it was rounded
  data.width = length("width of cut at this depth",
                      cut.width.value_or(defaultWidth(cut, data.effective_diameter)),
                      widest);
  data.chip_load = length("chip load",
                          cut.chip_load.value_or(std::min(cut.material.chip_ratio * end,
                                                          cut.material.chip_limit)),
                          0.1 * end);
  data.surface_speed = cut.surface_speed ? *cut.surface_speed : defaultSpeed(cut);
  checkRange(who, "surface speed", data.surface_speed, "m/min", {1, 5000});
  data.coolant = cut.material.coolant;
  return data;
}

void setSpindle(CuttingData& data, const Machine& machine)
{
  data.spindle = 1000 * data.surface_speed / (kPi * data.effective_diameter);
  if (machine.max_spindle > 0 && data.spindle > machine.max_spindle) {
    data.spindle = machine.max_spindle;
    data.limits.push_back(CutLimit::MaxSpindle);
  }
  else if (data.spindle < machine.min_spindle) {
    data.spindle = machine.min_spindle;
    data.limits.push_back(CutLimit::MinSpindle);
  }
  data.surface_speed = data.spindle * kPi * data.effective_diameter / 1000;
}

/// What comes of the feed per tooth.
void follow(CuttingData& data, const CutSetting& cut, const Edge& edge)
{
  const double fz = data.feed_per_tooth;
  data.feed = data.spindle * cut.tool.flutes * fz;
  data.max_chip = fz * edge.sine * radialThinning(data.width, edge.diameter);
  data.mean_chip = fz * edge.mean_sine * radialMean(data.width, edge.diameter);
  data.removal_rate = data.depth * data.width * data.feed / 1000;
  data.cutting_force = cut.material.kc11 * std::pow(data.mean_chip, -cut.material.mc);
  data.power = data.removal_rate * data.cutting_force / 60;
  data.torque = 60 * data.power / (2 * kPi * data.spindle);
}

/// Brings the feed down to @p share for @p limit.
void hold(CuttingData& data,
          const CutSetting& cut,
          const Edge& edge,
          double share,
          CutLimit limit)
{
  data.feed_per_tooth *= share;
  follow(data, cut, edge);
  data.limits.push_back(limit);
}

/// Whole numbers are what people set; downwards, so that limits stay kept.
double whole(double value)
{
  return value >= 1 ? std::floor(value) : value;
}

} // namespace

const char* nameOf(CutLimit limit)
{
  switch (limit) {
  case CutLimit::MinSpindle:
    return "min spindle";
  case CutLimit::MaxSpindle:
    return "max spindle";
  case CutLimit::Thinning:
    return "max thinning";
  case CutLimit::StepOver:
    return "step-over";
  case CutLimit::MaxFeed:
    return "max feed";
  case CutLimit::Power:
    return "power";
  }
  return "";
}

CuttingData cuttingData(const CutSetting& cut, const Machine& machine)
{
  cut.material.validate();
  cut.tool.validate();
  machine.validate();
  checkRange("cutting", "max thinning", cut.max_thinning, "", {1, 10});
  checkRange("cutting", "plunge ratio", cut.plunge_ratio, "", {0.01, 1});
  CuttingData data = asked(cut);
  const Edge edge = edgeOf(cut.tool, data.depth);
  setSpindle(data, machine);

  const auto atMost = [&](double most, CutLimit limit) {
    if (data.feed_per_tooth <= most)
      return;
    data.feed_per_tooth = most;
    data.limits.push_back(limit);
  };
  data.feed_per_tooth =
      data.chip_load / (edge.sine * radialThinning(data.width, edge.diameter));
  atMost(cut.max_thinning * data.chip_load, CutLimit::Thinning);
  if (cut.kind == CutKind::Finishing && cut.tool.corner_radius > 0)
    atMost(data.width, CutLimit::StepOver);
  follow(data, cut, edge);
  if (machine.max_feed > 0 && data.feed > machine.max_feed)
    hold(data, cut, edge, machine.max_feed / data.feed, CutLimit::MaxFeed);
  if (machine.power > 0 && data.power > machine.power) {
    // Thinner chips take more force by their area: P goes with fz^(1 - mc).
    const double share =
        std::pow(machine.power / data.power, 1 / (1 - cut.material.mc));
    hold(data, cut, edge, share, CutLimit::Power);
  }
  data.plunge_feed = cut.plunge_ratio * data.feed;
  return data;
}

Cutting CuttingData::cutting() const
{
  return {whole(spindle), whole(feed), whole(plunge_feed), coolant};
}

} // namespace pointmill
