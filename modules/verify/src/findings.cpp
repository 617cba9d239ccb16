// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "findings.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace pointmill {

const std::vector<FindingCode>& findingCodes()
{
  constexpr Severity error = Severity::Error, warning = Severity::Warning;
  static const std::vector<FindingCode> codes = {
      {"gouge", error, "mm", "points of the part get too deep into a tool"},
      {"scan_gouge", error, "mm", "measured points get deeper into a tool than noise"},
      {"gap", error, "mm", "the bridge over a gap of the scan is cut into"},
      {"residual", error, "mm", "half of the points keep too much material"},
      {"rapid_in_stock", error, "mm", "a rapid runs into stock"},
      {"rapid_in_part", error, "mm", "a rapid may run into points of the part"},
      {"plunge", error, "mm", "a tool that is flat in its middle is sunk into stock"},
      {"flute_length", error, "mm", "a layer is thicker than the flutes are long"},
      {"shank", error, "mm", "the shank runs into stock or part"},
      {"holder", error, "mm", "the tool holder runs into stock or part"},
      {"keep_out", error, "mm", "a tool gets into a keep-out zone or its margin"},
      {"below_stock", error, "mm", "a move goes below the bottom of the stock"},
      {"outside_travel", error, "mm", "a move leaves the machine's travel"},
      {"feed", error, "mm/min", "a feed move has no sensible feed"},
      {"feed_limit", error, "mm/min", "the feed is above the machine's"},
      {"spindle", error, "rev/min", "the spindle stands or turns backwards in a cut"},
      {"spindle_limit",
       error,
       "rev/min",
       "the spindle's speed is beyond the machine's, by"},
      {"unknown_tool", error, "", "a feed move has a tool that is not known"},
      {"no_tool_below_stock",
       error,
       "",
       "a rapid without a tool comes below the safe height"},
      {"unknown_position", error, "", "a move from or to an unknown place may be low"},
      {"length_offset", error, "", "a move lacks the tool's length (G43 with its H)"},
      {"unsafe_tool_change", error, "mm", "a tool is changed below the safe height"},
      {"unsafe_end", error, "mm", "the program ends below the safe height"},
      {"not_ended", error, "", "the program does not end with M2 or M30"},
      {"blend", error, "mm", "the control may round corners by too much (G64)"},
      {"empty", error, "", "the program takes nothing off the stock"},
      {"pressed_in",
       warning,
       "mm",
       "a tool that is flat in its middle is pressed into stock, as few must be"},
      {"leaves_more", warning, "mm", "more stays than the job's own program leaves"},
      {"axial_depth", warning, "mm", "a layer is thicker than the tool's limit"},
      {"chip_load", warning, "mm", "the feed per tooth is beyond any tool of its size"},
      {"spindle_change", warning, "rev/min", "the spindle's speed changes in a cut"},
      {"cuts_nothing", warning, "", "an operation takes nothing off the stock"},
  };
  return codes;
}

namespace {

/// What is counted.
const char* things(const std::string& code)
{
  return code == "gouge" || code == "scan_gouge" || code == "gap" ? "points" : "times";
}

/// A limit as it was given, "4.5".
std::string shortly(double limit)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << limit;
  return text.str();
}

std::string textOf(const FindingCode& code, const Finding& finding)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << code.meaning;
  const char* separator = ": ";
  const auto next = [&]() -> std::ostream& {
    text << separator;
    separator = ", ";
    return text;
  };
  if (!code.unit.empty()) {
    text.precision(code.unit == "mm" ? 3 : 0);
    if (std::isfinite(finding.worst))
      next() << std::fixed << finding.worst << " " << code.unit;
    else
      next() << "without limit";
    if (finding.limit > 0)
      next() << "limit " << shortly(finding.limit) << " " << code.unit;
  }
  if (finding.count > 1)
    next() << finding.count << " " << things(code.code);
  if (finding.tool > 0)
    next() << "T" << finding.tool;
  return text.str();
}

} // namespace

void Findings::add(const char* code,
                   double worst,
                   const Eigen::Vector3d& place,
                   std::size_t line,
                   int tool,
                   std::size_t count,
                   double limit)
{
  auto found = by_code_.find(code);
  if (found == by_code_.end())
    found =
        by_code_.emplace(code, Finding{code, "", worst, place, limit, line, tool, 0})
            .first;
  Finding& finding = found->second;
  const std::size_t all = finding.count + count;
  if (worst > finding.worst)
    finding = {code, "", worst, place, limit, line, tool};
  finding.count = all;
}

std::vector<Finding> Findings::list() const
{
  std::vector<Finding> list;
  for (const auto& code : findingCodes()) {
    const auto found = by_code_.find(code.code);
    if (found == by_code_.end())
      continue;
    list.push_back(found->second);
    list.back().severity = code.severity;
    list.back().text = textOf(code, list.back());
  }
  return list;
}

} // namespace pointmill
