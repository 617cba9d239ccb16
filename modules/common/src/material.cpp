// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/material.h>
#include <pointmill/common/nearest_name.h>

#include <cctype>
#include <sstream>

namespace pointmill {

namespace {

/// Lower case, with hyphens for what parts words: as the names of the table are.
std::string plain(const std::string& text)
{
  std::string out;
  bool parted = false;
  for (const unsigned char c : text)
    if (std::isspace(c) || c == '_' || c == '-')
      parted = !out.empty();
    else {
      out += parted ? "-" : "";
      out += static_cast<char>(std::tolower(c));
      parted = false;
    }
  return out;
}

std::vector<std::string> namesOf(const WorkMaterial& material)
{
  std::istringstream also(material.also);
  std::vector<std::string> names = {material.name};
  for (std::string name; also >> name;)
    names.push_back(name);
  return names;
}

std::vector<std::string> allNames()
{
  std::vector<std::string> all;
  for (const auto& material : workMaterials())
    for (const auto& name : namesOf(material))
      all.push_back(name);
  return all;
}

} // namespace

void WorkMaterial::validate() const
{
  const std::string who = "material " + name;
  const auto speeds = [&](const std::string& tool, const Range& range, double least) {
    checkRange(who, tool + " speed", range.low, "m/min", {least, 5000});
    checkRange(who, tool + " finishing speed", range.high, "m/min", {range.low, 5000});
  };
  speeds("carbide", carbide_speed, 1);
  speeds("high-speed steel", hss_speed, 0);
  checkRange(who, "chip load by diameter", chip_ratio, "", {1e-5, 0.1});
  checkRange(who, "limit of the chip load", chip_limit, "mm", {1e-4, 5});
  checkRange(who, "roughing depth by diameter", rough_depth, "", {1e-3, 5});
  checkRange(who, "kc1.1", kc11, "N/mm2", {0.01, 1e5});
  checkRange(who, "mc", mc, "", {0, 0.9});
}

const WorkMaterial& workMaterial(const std::string& name)
{
  const std::string wanted = plain(name);
  for (const auto& material : workMaterials())
    for (const auto& known : namesOf(material))
      if (known == wanted)
        return material;
  throw ParameterError("unknown material '" + name + "', did you mean '" +
                       nearestName(wanted, allNames()) + "'?");
}

const std::vector<WorkMaterial>& workMaterials()
{
  // Name, other names, what it is, speed of carbide and of high-speed steel [m/min],
  // chip load by diameter and its limit [mm], roughing depth by diameter, kc1.1
  // [N/mm2], mc, coolant. Sources: doc/cutting.md.
  static const std::vector<WorkMaterial> materials = {
      {"aluminium-wrought",
       "aluminium aluminum aluminum-wrought 2024 6061 6082 7075",
       "wrought aluminium alloys, heat-treated, 100 HB",
       {300, 600},
       {60, 120},
       0.008,
       0.15,
       0.5,
       800,
       0.25,
       true},
      {"aluminium-cast",
       "aluminum-cast cast-aluminium cast-aluminum a356 alsi12",
       "cast aluminium alloys, up to 12 % silicon, 90 HB",
       {200, 400},
       {45, 90},
       0.008,
       0.15,
       0.5,
       700,
       0.25,
       true},
      {"brass",
       "c360 cuzn39pb3",
       "free-cutting brass, 110 HB",
       {150, 350},
       {45, 90},
       0.006,
       0.12,
       0.5,
       700,
       0.27,
       false},
      {"copper",
       "cu-etp c110",
       "electrolytic copper, 100 HB",
       {120, 250},
       {30, 60},
       0.006,
       0.12,
       0.4,
       700,
       0.27,
       true},
      {"mild-steel",
       "steel 1018 a36 s235 st37",
       "unalloyed steel under 0.25 % carbon, 125 HB",
       {140, 230},
       {20, 35},
       0.005,
       0.12,
       0.4,
       1350,
       0.21,
       true},
      {"alloy-steel",
       "4140 42crmo4",
       "low-alloyed steel, annealed, 200 HB",
       {90, 170},
       {15, 25},
       0.004,
       0.10,
       0.3,
       1775,
       0.24,
       true},
      {"tool-steel",
       "d2 h13 o1 1.2379 1.2344",
       "high-alloyed and tool steel, annealed, 200 HB",
       {80, 150},
       {10, 18},
       0.004,
       0.08,
       0.25,
       2450,
       0.23,
       true},
      {"hardened-steel",
       "hardened-tool-steel",
       "hardened steel, 55 HRC",
       {40, 80},
       {0, 0},
       0.002,
       0.04,
       0.05,
       4600,
       0.25,
       false},
      {"stainless-steel",
       "stainless 304 316 1.4301 1.4404",
       "austenitic stainless steel, 180 HB",
       {60, 110},
       {10, 18},
       0.004,
       0.08,
       0.25,
       2150,
       0.20,
       true},
      {"cast-iron",
       "gg25 gjl-250 grey-cast-iron gray-cast-iron",
       "grey cast iron, 180 HB",
       {100, 200},
       {15, 25},
       0.006,
       0.12,
       0.4,
       1150,
       0.20,
       false},
      {"titanium",
       "ti6al4v ti-6al-4v grade-5",
       "titanium alloy Ti-6Al-4V, 330 HB",
       {40, 70},
       {8, 15},
       0.003,
       0.08,
       0.25,
       2110,
       0.22,
       true},
      {"pom",
       "acetal delrin",
       "acetal",
       {280, 500},
       {90, 240},
       0.012,
       0.25,
       0.8,
       80,
       0.25,
       false},
      {"abs",
       "",
       "acrylonitrile butadiene styrene",
       {300, 500},
       {90, 240},
       0.012,
       0.25,
       0.8,
       60,
       0.25,
       false},
      {"acrylic",
       "pmma perspex plexiglas plexiglass",
       "cast acrylic",
       {150, 300},
       {90, 150},
       0.012,
       0.20,
       0.5,
       90,
       0.25,
       false},
      {"hardwood",
       "beech maple oak walnut",
       "hardwood",
       {400, 900},
       {90, 150},
       0.020,
       0.40,
       0.8,
       20,
       0.40,
       false},
      {"softwood",
       "pine spruce",
       "softwood",
       {400, 900},
       {90, 150},
       0.025,
       0.45,
       1.0,
       12,
       0.40,
       false},
      {"plywood",
       "",
       "plywood",
       {400, 900},
       {90, 150},
       0.025,
       0.45,
       0.8,
       16,
       0.40,
       false},
      {"mdf",
       "particle-board chipboard",
       "medium-density fibreboard, particle board",
       {400, 900},
       {90, 150},
       0.030,
       0.50,
       0.8,
       16,
       0.40,
       false},
      {"tooling-board",
       "modelling-board polyurethane-board",
       "polyurethane board, 0.7 g/cm3",
       {300, 800},
       {90, 240},
       0.020,
       0.40,
       1.0,
       12,
       0.30,
       false},
      {"wax",
       "modelling-wax machinable-wax",
       "machinable wax",
       {200, 500},
       {90, 240},
       0.015,
       0.30,
       1.0,
       10,
       0.25,
       false},
      {"foam",
       "styrofoam polystyrene-foam polyurethane-foam",
       "rigid foam, under 0.2 g/cm3",
       {400, 1000},
       {90, 240},
       0.030,
       0.80,
       2.0,
       2,
       0.25,
       false},
      {"graphite",
       "",
       "electrode graphite",
       {150, 300},
       {0, 0},
       0.006,
       0.10,
       0.5,
       100,
       0.25,
       false},
  };
  return materials;
}

} // namespace pointmill
