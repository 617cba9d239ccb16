// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "setup_sheet.h"

#include "page_parts.h"
#include "print.h"

#include <pointmill/page/setup_sketch.h>
#include <pointmill/visual/palette.h>

#include <algorithm>
#include <cmath>

namespace pointmill::page {
namespace {

std::string millimetres(double value)
{
  return print("%.3f", value);
}

/// "2.000 mm right of" what is to the left.
std::string aside(double by, const char* more, const char* less, const char* what)
{
  if (std::abs(by) < 5e-4)
    return std::string("at ") + what;
  return print("%.3f mm %s ", std::abs(by), by > 0 ? more : less) + what;
}

Html stockText(const MillJob& job)
{
  const Stock& s = job.stock();
  const Eigen::Vector3d size = s.max - s.min;
  return print("%.3f \u00d7 %.3f \u00d7 %.3f mm (X \u00d7 Y \u00d7 Z)",
               size.x(),
               size.y(),
               size.z()) +
         std::string(job.options().stock_scan.empty()
                         ? ""
                         : ", the box round the raw part, which was scanned");
}

Html datumText(const MillJob& job)
{
  const Stock& s = job.stock();
  const MillOptions& o = job.options();
  return std::string("X0 Y0 is the ") +
         (o.datum_xy == DatumXY::Corner ? "front left corner" : "centre") +
         " of the part's box, Z0 its " + (o.datum_z == DatumZ::Top ? "top" : "bottom") +
         ". On the stock X0 is " +
         aside(-s.min.x(), "right of", "left of", "its left side") + ", Y0 " +
         aside(-s.min.y(), "behind", "before", "its front") + ", Z0 " +
         aside(s.max.z(), "below", "above", "its top") + ".";
}

/// The offset that the program's modes select.
std::string offsetOf(const Post& post)
{
  for (const auto& line : post.setup)
    for (std::size_t at = line.find("G5"); at != std::string::npos;
         at = line.find("G5", at + 1))
      if (at + 2 < line.size() && line[at + 2] >= '4' && line[at + 2] <= '9')
        return line.substr(at, 3) + ": set it to the datum";
  return "the preset that is active in the control: set it to the datum";
}

Html zonesText(const KeepOut& keep_out)
{
  Html list;
  int number = 0;
  for (const auto& zone : keep_out.zones())
    list += element("div", print("K%d: ", ++number) + zone.describe());
  return list +
         element("div", print("Tools keep %.2f mm away from them.", keep_out.margin()));
}

double highest(const MillJob& job)
{
  return std::max(job.stock().top(), job.options().keep_out.highestTop());
}

std::string orDash(double value)
{
  return value > 0 ? print("%.4g", value) : "-";
}

Html toolsTable(const MillJob& job)
{
  const auto& tips = job.verification().lowest_tip;
  std::vector<std::vector<Html>> rows;
  std::vector<Tool> tools = job.tools();
  std::sort(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) {
    return a.number < b.number;
  });
  for (const Tool& t : tools) {
    const auto tip = tips.find(t.number);
    const bool used = tip != tips.end();
    const double reach = used ? highest(job) - tip->second : 0.0;
    std::string type = t.type();
    if (t.isTapered())
      type += print(", %.4g deg, tip %.4g", t.taper, t.tip_diameter);
    Html stick_out = used ? print("\u2265 %.1f", std::ceil(reach * 10) / 10)
                          : std::string("not used");
    if (t.stick_out > 0)
      stick_out +=
          Html::markup("<br>") + element("small", print("as given %.4g", t.stick_out));
    rows.push_back({"T" + std::to_string(t.number),
                    type,
                    print("%.4g", t.diameter),
                    orDash(t.corner_radius),
                    std::to_string(t.flutes),
                    orDash(t.flute_length),
                    orDash(t.shank_diameter),
                    orDash(t.holder_diameter),
                    used ? print("%.3f", tip->second) : std::string("-"),
                    stick_out});
  }
  return table("Tools",
               {{"tool", false, ""},
                {"type", false, ""},
                {"diameter", true, "mm"},
                {"corner", true, "R mm"},
                {"flutes", true, ""},
                {"flutes' length", true, "mm"},
                {"shank", true, "mm"},
                {"holder", true, "mm"},
                {"lowest tip", true, "Z mm"},
                {"stick-out", true, "mm"}},
               rows) +
         element(
             "p",
             "The stick-out is from the tip to the holder: that much is needed lest "
             "the holder comes below the top of stock and zones. A dash is what was "
             "not given, and not checked.");
}

Html cuttingTable(const MillJob& job)
{
  std::vector<std::vector<Html>> rows;
  int number = 0;
  for (const auto& planned : job.operations()) {
    const Operation& o = planned.operation;
    const double tooth = o.cutting.feed / (o.cutting.spindle * o.tool.flutes);
    rows.push_back(
        {swatch(operationColour(planned.colour)) + print("%d  ", ++number) + o.name,
         "T" + std::to_string(o.tool.number),
         print("%.0f", o.cutting.spindle),
         print("%.0f", o.cutting.feed),
         print("%.3f", tooth),
         print("%.0f", o.cutting.plunge_feed),
         print("%.2f", planned.allowance),
         o.cutting.coolant ? "on" : "off",
         hoursAndMinutes(planned.figures.minutes)});
  }
  return table("Cutting data, in the order of machining",
               {{"operation", false, ""},
                {"tool", false, ""},
                {"spindle", true, "rev/min"},
                {"feed", true, "mm/min"},
                {"per tooth", true, "mm"},
                {"plunge feed", true, "mm/min"},
                {"leaves", true, "mm"},
                {"coolant", false, ""},
                {"time", true, ""}},
               rows);
}

} // namespace

Html setupSheet(const MillJob& job, bool written)
{
  const Stock& s = job.stock();
  const GCodeWriter& writer = job.options().writer;
  SetupScene scene;
  scene.stock = s;
  const auto low = job.criteria().part->min(), high = job.criteria().part->max();
  scene.part_min = low;
  scene.part_max = high;
  scene.part = &job.map();
  scene.keep_out = &job.options().keep_out;
  scene.clearance = job.clearancePlane();
  scene.lowest = job.floor();
  for (const auto& [tool, tip] : job.verification().lowest_tip)
    scene.lowest = std::min(scene.lowest, tip);
  std::vector<std::pair<std::string, Html>> list{
      {"Stock", stockText(job)},
      {"Lies at",
       print("X%.3f to %.3f, Y%.3f to %.3f, Z%.3f to %.3f",
             s.min.x(),
             s.max.x(),
             s.min.y(),
             s.max.y(),
             s.min.z(),
             s.max.z())},
      {"Datum", datumText(job)},
      {"Work offset", offsetOf(writer.getPost())},
      {"Clearance plane",
       "Z" + millimetres(job.clearancePlane()) +
           ": rapids may go sideways anywhere at this height"},
      {"Lowest tip",
       "Z" + millimetres(scene.lowest) +
           print(", %.3f mm above the bottom of the stock", scene.lowest - s.min.z())}};
  if (!job.options().keep_out.empty())
    list.emplace_back("Keep-out zones", zonesText(job.options().keep_out));
  Html programs;
  for (const auto& program : job.programs())
    programs += element("div", element("code", program.name));
  list.emplace_back("Program", written ? programs : Html("none was written"));
  list.emplace_back("Control",
                    writer.getPost().control + (writer.getUnit() == Unit::Inch
                                                    ? ", program in inches (this sheet "
                                                      "is in millimetres)"
                                                    : ", program in millimetres"));
  return element("div class=\"sketch-room\"", setupSketch(scene)) + terms(list) +
         toolsTable(job) + cuttingTable(job);
}

} // namespace pointmill::page
