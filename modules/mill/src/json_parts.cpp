// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "json_parts.h"

#include <cmath>

namespace pointmill::json {
namespace {

Json of(const KeepOutZone& zone)
{
  Json json = {{"what", zone.describe()}, {"top", zone.top()}};
  if (zone.radius() > 0)
    json["radius"] = zone.radius();
  for (const auto& c : zone.corners())
    json["corners"].push_back({c.x(), c.y()});
  return json;
}

KeepOutZone zoneFrom(const Json& json)
{
  const double top = json.at("top");
  std::vector<Eigen::Vector2d> corners;
  for (const auto& c : json.at("corners"))
    corners.emplace_back(c.at(0).get<double>(), c.at(1).get<double>());
  if (json.contains("radius"))
    return KeepOutZone::cylinder(
        corners.at(0).x(), corners.at(0).y(), json.at("radius"), top);
  return KeepOutZone::polygon(std::move(corners), top);
}

} // namespace

Eigen::Vector3d vectorFrom(const Json& json)
{
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json number(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json vector(const Eigen::Vector3d& v)
{
  return {number(v.x()), number(v.y()), number(v.z())};
}

Json of(const Tool& tool)
{
  Json json = {{"number", tool.number},
               {"type", tool.type()},
               {"diameter", tool.diameter},
               {"corner_radius", tool.corner_radius},
               {"flutes", tool.flutes}};
  if (tool.isTapered()) {
    json["taper_deg"] = tool.taper;
    json["tip_diameter"] = tool.tip_diameter;
  }
  const auto add = [&](const char* name, double value) {
    if (value > 0)
      json[name] = value;
  };
  add("flute_length", tool.flute_length);
  add("shank_diameter", tool.shank_diameter);
  add("stick_out", tool.stick_out);
  add("holder_diameter", tool.holder_diameter);
  return json;
}

Tool toolFrom(const Json& json)
{
  Tool tool;
  tool.number = json.at("number");
  tool.diameter = json.at("diameter");
  tool.corner_radius = json.at("corner_radius");
  tool.flutes = json.at("flutes");
  tool.taper = json.value("taper_deg", 0.0);
  tool.tip_diameter = json.value("tip_diameter", 0.0);
  tool.flute_length = json.value("flute_length", 0.0);
  tool.shank_diameter = json.value("shank_diameter", 0.0);
  tool.stick_out = json.value("stick_out", 0.0);
  tool.holder_diameter = json.value("holder_diameter", 0.0);
  tool.validate();
  return tool;
}

Json of(const Stock& stock)
{
  return {{"min", vector(stock.min)}, {"max", vector(stock.max)}};
}

Stock stockFrom(const Json& json)
{
  return {vectorFrom(json.at("min")), vectorFrom(json.at("max"))};
}

Json of(const KeepOut& keep_out)
{
  Json json = Json::object();
  for (const auto& zone : keep_out.zones())
    json["zones"].push_back(of(zone));
  json["margin_mm"] = keep_out.margin();
  return json;
}

KeepOut keepOutFrom(const Json& json)
{
  std::vector<KeepOutZone> zones;
  if (json.contains("zones"))
    for (const auto& zone : json.at("zones"))
      zones.push_back(zoneFrom(zone));
  return KeepOut(std::move(zones), json.at("margin_mm"));
}

Json of(const Machine& machine)
{
  Json json = {{"rapid_mm_min", machine.rapid_rate},
               {"acceleration_mm_s2", machine.acceleration},
               {"junction_deviation_mm", machine.junction_deviation}};
  const auto add = [&](const char* name, double value) {
    if (value > 0)
      json[name] = value;
  };
  add("max_feed_mm_min", machine.max_feed);
  add("min_spindle_rpm", machine.min_spindle);
  add("max_spindle_rpm", machine.max_spindle);
  add("power_w", machine.power);
  if (machine.travel)
    json["travel"] = of(*machine.travel);
  return json;
}

Machine machineFrom(const Json& json)
{
  Machine machine;
  machine.rapid_rate = json.at("rapid_mm_min");
  machine.acceleration = json.at("acceleration_mm_s2");
  machine.junction_deviation = json.at("junction_deviation_mm");
  machine.max_feed = json.value("max_feed_mm_min", 0.0);
  machine.min_spindle = json.value("min_spindle_rpm", 0.0);
  machine.max_spindle = json.value("max_spindle_rpm", 0.0);
  machine.power = json.value("power_w", 0.0);
  if (json.contains("travel"))
    machine.travel = stockFrom(json.at("travel"));
  machine.validate();
  return machine;
}

} // namespace pointmill::json
