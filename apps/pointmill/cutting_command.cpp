// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cutting_command.h"

#include "cutting_json.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace pointmill;

namespace {

/// The preset of --max-spindle: that of a common router spindle.
constexpr double kMaxSpindle = 24000;

/// Three digits that say something.
std::string number(double value)
{
  const int whole = value > 0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(std::min(6, std::max(0, 2 - whole))) << value;
  return text.str();
}

/// Cutting::spindle and feeds are whole where they are not tiny.
std::string whole(double value)
{
  return value >= 1 ? std::to_string(std::lround(value)) : number(value);
}

std::string timeText(double seconds)
{
  return seconds < 120 ? number(seconds) + " s" : number(seconds / 60) + " min";
}

void row(const std::string& name, const std::string& value)
{
  std::cout << "  " << std::left << std::setw(24) << name << value << '\n';
}

void printList()
{
  std::cout << std::left << std::setw(19) << "material" << std::right << std::setw(10)
            << "carbide" << std::setw(10) << "HSS" << std::setw(8) << "fz/D"
            << std::setw(8) << "fz max" << std::setw(7) << "kc1.1" << std::setw(6)
            << "mc"
            << "  is\n"
            << std::left << std::setw(19) << "" << std::right << std::setw(10)
            << "m/min" << std::setw(10) << "m/min" << std::setw(16) << "mm"
            << std::setw(7) << "N/mm2" << '\n';
  const auto range = [](const Range& r) {
    return r.high > 0 ? std::to_string(std::lround(r.low)) + "-" +
                            std::to_string(std::lround(r.high))
                      : std::string("no");
  };
  for (const WorkMaterial& m : workMaterials())
    std::cout << std::left << std::setw(19) << m.name << std::right << std::setw(10)
              << range(m.carbide_speed) << std::setw(10) << range(m.hss_speed)
              << std::setw(8) << m.chip_ratio << std::setw(8) << m.chip_limit
              << std::setw(7) << m.kc11 << std::setw(6) << m.mc << "  " << m.description
              << '\n';
}

/// The value with what held it back, if one of these did.
std::string
held(const CuttingData& data, std::initializer_list<CutLimit> limits, std::string text)
{
  for (const CutLimit limit : limits)
    if (std::count(data.limits.begin(), data.limits.end(), limit) > 0)
      text +=
          std::string(text.find("<-") == text.npos ? "  <- " : ", ") + nameOf(limit);
  return text;
}

void print(const CuttingCommand& command,
           const CutSetting& cut,
           const CuttingData& data)
{
  const Cutting set = data.cutting();
  std::cout << cut.material.name << ", " << cut.tool.describe().substr(3) << ", "
            << cut.tool.flutes << (cut.tool.flutes == 1 ? " flute, " : " flutes, ")
            << (command.hss ? "high-speed steel, " : "carbide, ") << command.kind
            << "\n\n";
  row("depth of cut ap", number(data.depth) + " mm");
  row("width of cut ae", number(data.width) + " mm");
  row("effective diameter", number(data.effective_diameter) + " mm");
  row("surface speed vc", number(data.surface_speed) + " m/min");
  row("spindle speed n",
      held(data,
           {CutLimit::MinSpindle, CutLimit::MaxSpindle},
           whole(set.spindle) + " rev/min"));
  row("feed per tooth fz",
      held(data,
           {CutLimit::Thinning, CutLimit::StepOver},
           number(data.feed_per_tooth) + " mm"));
  row("feed vf",
      held(data, {CutLimit::MaxFeed, CutLimit::Power}, whole(set.feed) + " mm/min"));
  row("plunge feed", whole(set.plunge_feed) + " mm/min");
  row("thickest chip",
      number(data.max_chip) + " mm of " + number(data.chip_load) + " mm wanted" +
          (data.rubs() ? "  <- it rubs" : ""));
  row("mean chip hm", number(data.mean_chip) + " mm");
  row("removal rate Q", number(data.removal_rate) + " cm3/min");
  row("specific force kc", number(data.cutting_force) + " N/mm2");
  row("power Pc", number(data.power) + " W");
  row("torque Mc", number(data.torque) + " N m");
  row("coolant", data.coolant ? "flood" : "none, or air");
  if (command.length)
    row("time for " + number(*command.length) + " mm",
        timeText(data.secondsForLength(*command.length)));
  if (command.volume)
    row("time for " + number(*command.volume) + " cm3",
        timeText(data.secondsForVolume(1000 * *command.volume)));
}

} // namespace

CLI::App* declareCutting(CLI::App& app, CuttingCommand& command)
{
  CLI::App* cutting = app.add_subcommand(
      "cutting", "feeds and speeds of a tool in a material, within what a machine can");
  cutting->add_flag("--list", command.list, "print the materials and their data");
  cutting->add_option("--material", command.material, "one of --list")
      ->type_name("NAME");
  command.output.declareJson(*cutting);
  command.tool.declare(*cutting, "Tool", Tool::flat(1, 6.0));
  cutting->add_flag("--hss", command.hss, "of high-speed steel, not carbide")
      ->group("Tool");
  const auto add = [&](const char* name,
                       auto& value,
                       const char* unit,
                       const std::string& preset,
                       const char* help,
                       const char* group) {
    cutting->add_option(name, value, help)
        ->type_name(unit)
        ->default_str(preset)
        ->group(group);
  };
  add("--cut",
      command.kind,
      "roughing|finishing",
      command.kind,
      "which end of the surface speeds, which depth and width",
      "Cut");
  CutSetting& cut = command.cut;
  add("--surface-speed",
      cut.surface_speed,
      "M/MIN",
      "",
      "instead of the material's",
      "Cut");
  add("--chip-load", cut.chip_load, "MM", "", "thickest chip that is wanted", "Cut");
  add("--ap", cut.depth, "MM", "", "depth of cut", "Cut");
  add("--ae", cut.width, "MM", "", "width of cut", "Cut");
  add("--max-thinning",
      cut.max_thinning,
      "X",
      number(cut.max_thinning),
      "the most that the feed per tooth is raised for thin chips",
      "Cut");
  add("--length", command.length, "MM", "", "print the time for this length", "Cut");
  add("--volume", command.volume, "CM3", "", "print the time for this volume", "Cut");
  Machine& machine = command.machine;
  machine.max_spindle = kMaxSpindle;
  const char* const none = "0: no limit";
  add("--max-spindle",
      machine.max_spindle,
      "RPM",
      number(kMaxSpindle),
      none,
      "Machine");
  add("--min-spindle", machine.min_spindle, "RPM", "0", none, "Machine");
  add("--max-feed", machine.max_feed, "MM/MIN", "0", none, "Machine");
  add("--power", machine.power, "W", "0", "at the spindle; 0: no limit", "Machine");
  return cutting;
}

int runCutting(const CuttingCommand& command)
{
  if (command.list) {
    if (command.output.json)
      writeResult(0, "done", materialsJson());
    else
      printList();
    return 0;
  }
  if (command.material.empty())
    throw ParameterError("cutting: --material is needed, one of --list");
  if (command.kind != "roughing" && command.kind != "finishing")
    throw ParameterError("cutting: --cut must be roughing|finishing, not " +
                         command.kind);
  for (const auto& [name, value] :
       {std::pair{"--length", command.length}, std::pair{"--volume", command.volume}})
    if (value)
      checkRange("cutting", name, *value, "", {0, 1e12});
  CutSetting cut = command.cut;
  cut.material = workMaterial(command.material);
  cut.tool = command.tool.toolFrom(Tool::flat(1, 6.0));
  cut.kind = command.kind == "roughing" ? CutKind::Roughing : CutKind::Finishing;
  cut.tool_material = command.hss ? ToolMaterial::Hss : ToolMaterial::Carbide;
  const CuttingData data = cuttingData(cut, command.machine);
  if (command.output.json)
    writeResult(0, "done", cuttingJson(command, cut, data));
  else
    print(command, cut, data);
  return 0;
}
