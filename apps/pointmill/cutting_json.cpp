// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cutting_json.h"

using namespace pointmill;
using Json = nlohmann::ordered_json;

Json cuttingJson(const CuttingCommand& command,
                 const CutSetting& cut,
                 const CuttingData& data)
{
  const Cutting set = data.cutting();
  Json json = {{"material", cut.material.name},
               {"tool", cut.tool.describe().substr(3)},
               {"flutes", cut.tool.flutes},
               {"tool_material", command.hss ? "hss" : "carbide"},
               {"cut", command.kind},
               {"depth_mm", data.depth},
               {"width_mm", data.width},
               {"effective_diameter_mm", data.effective_diameter},
               {"surface_speed_m_min", data.surface_speed},
               {"spindle_rpm", set.spindle},
               {"feed_per_tooth_mm", data.feed_per_tooth},
               {"feed_mm_min", set.feed},
               {"plunge_feed_mm_min", set.plunge_feed},
               {"max_chip_mm", data.max_chip},
               {"chip_load_mm", data.chip_load},
               {"mean_chip_mm", data.mean_chip},
               {"rubs", data.rubs()},
               {"removal_rate_cm3_min", data.removal_rate},
               {"specific_force_n_mm2", data.cutting_force},
               {"power_w", data.power},
               {"torque_nm", data.torque},
               {"coolant", data.coolant},
               {"limited_by", Json::array()}};
  for (const CutLimit limit : data.limits)
    json["limited_by"].push_back(nameOf(limit));
  if (command.length)
    json["seconds_for_length"] = data.secondsForLength(*command.length);
  if (command.volume)
    json["seconds_for_volume"] = data.secondsForVolume(1000 * *command.volume);
  return json;
}

Json materialsJson()
{
  const auto range = [](const Range& r) -> Json {
    return r.high > 0 ? Json{r.low, r.high} : Json(nullptr);
  };
  Json list = Json::array();
  for (const WorkMaterial& m : workMaterials())
    list.push_back({{"name", m.name},
                    {"description", m.description},
                    {"carbide_m_min", range(m.carbide_speed)},
                    {"hss_m_min", range(m.hss_speed)},
                    {"feed_per_tooth_of_diameter", m.chip_ratio},
                    {"max_feed_per_tooth_mm", m.chip_limit},
                    {"kc11_n_mm2", m.kc11},
                    {"mc", m.mc}});
  return {{"materials", list}};
}
