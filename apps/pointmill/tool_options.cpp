// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "tool_options.h"

#include <pointmill/common/error.h>

using pointmill::ParameterError;
using pointmill::Tool;

namespace {

const char* const kTypes = "flat|ball|bull|taper|cone";

/// How an option befits a type of tool.
enum class Use { Needs, Takes, Refuses };

void check(const ToolOptions& options,
           const std::string& type,
           const char* option,
           const std::optional<double>& value,
           Use use)
{
  const std::string name = options.option(option);
  const std::string kind = options.option("-type") + " " + type;
  if (use == Use::Needs && !value)
    throw ParameterError(kind + " needs " + name);
  if (use == Use::Refuses && value)
    throw ParameterError(name + " does not befit " + kind);
}

} // namespace

std::string ToolOptions::option(const std::string& ending) const
{
  return name.empty() ? "-" + ending : "--" + name + ending;
}

void ToolOptions::declare(CLI::App& app, const std::string& group, const Tool& standard)
{
  const auto add = [&](const char* option,
                       auto& value,
                       const char* unit,
                       const std::string& preset,
                       const char* help) {
    app.add_option(this->option(option), value, help)
        ->type_name(unit)
        ->default_str(preset)
        ->group(group);
  };
  const auto number = [](double value) { return CLI::detail::to_string(value); };
  add("-type", type, kTypes, standard.type(), "kind of the cutter");
  add("-diameter", diameter, "MM", number(standard.diameter), "its largest diameter");
  add("-corner", corner, "MM", "", "corner radius, of a bull or a tapered bull");
  add("-taper", taper, "DEG", "", "half-angle from the axis, of a taper or a cone");
  add("-tip", tip, "MM", "", "diameter at the tip, of a taper or a cone");
  add("-flute-length", flute_length, "MM", "", "refuse cuts that are deeper");
  add("-shank", shank, "MM", "", "diameter above the flutes");
  add("-stick-out", stick_out, "MM", "", "from the tip to the holder");
  add("-holder", holder, "MM", "", "diameter of the holder");
  add("-flutes", flutes, "N", std::to_string(standard.flutes), "number of teeth");
}

Tool ToolOptions::toolFrom(const Tool& standard) const
{
  const std::string kind = type.value_or(standard.type());
  const bool bull = kind == "bull", taper_kind = kind == "taper", cone = kind == "cone";
  if (("|" + std::string(kTypes) + "|").find("|" + kind + "|") == std::string::npos)
    throw ParameterError(option("-type") + " must be " + kTypes + ", not " + kind);
  check(*this,
        kind,
        "-corner",
        corner,
        bull         ? Use::Needs
        : taper_kind ? Use::Takes
                     : Use::Refuses);
  check(*this, kind, "-taper", taper, taper_kind || cone ? Use::Needs : Use::Refuses);
  check(*this,
        kind,
        "-tip",
        tip,
        taper_kind ? Use::Needs
        : cone     ? Use::Takes
                   : Use::Refuses);

  const int n = standard.number;
  const double d = diameter.value_or(standard.diameter);
  Tool tool = kind == "flat" ? Tool::flat(n, d)
              : bull         ? Tool::bull(n, d, *corner)
              : taper_kind
                  ? Tool::taperBull(n, *tip, corner.value_or(*tip / 2), *taper, d)
              : cone ? Tool::cone(n, *taper, d, tip.value_or(0.0))
                     : Tool::ball(n, d);
  tool.flute_length = flute_length.value_or(standard.flute_length);
  tool.flutes = flutes.value_or(standard.flutes);
  tool.shank_diameter = shank.value_or(standard.shank_diameter);
  tool.stick_out = stick_out.value_or(standard.stick_out);
  tool.holder_diameter = holder.value_or(standard.holder_diameter);
  return tool;
}
