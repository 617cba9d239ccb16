// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/tool.h>

#include <sstream>

namespace pointmill {

void checkRange(const std::string& stage,
                const std::string& name,
                double value,
                const std::string& unit,
                Range range)
{
  if (value >= range.low && value <= range.high)
    return;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << stage << ": " << name << " is " << value << " " << unit << "; it must lie in "
       << range.low << " .. " << range.high << " " << unit;
  throw ParameterError(text.str());
}

void Tool::validate() const
{
  const std::string who = "tool " + std::to_string(number);
  checkRange(who, "number", number, "", {1, 9999});
  checkRange(who, "diameter", diameter, "mm", {0.05, 200});
  checkRange(who, "taper", taper, "deg", {0, 80});
  if (isTapered()) { // a taper too slight to see would make the cone endless
    checkRange(who, "taper", taper, "deg", {0.1, 80});
    checkRange(who, "tip diameter", tip_diameter, "mm", {0, diameter});
  }
  else
    checkRange(who, "tip diameter without a taper", tip_diameter, "mm", {0, 0});
  checkRange(who, "corner radius", corner_radius, "mm", {0, tipRadius()});
  checkRange(who, "shoulder radius", shoulder_radius, "mm", {0, corner_radius});
  checkRange(who, "flute length", flute_length, "mm", {0, 500});
  checkRange(who, "flutes", flutes, "", {1, 20});
  checkRange(who, "shank diameter", shank_diameter, "mm", {0, 200});
  checkRange(who, "stick-out", stick_out, "mm", {0, 1000});
  checkRange(who, "holder diameter", holder_diameter, "mm", {0, 500});
  if (shank_diameter > 0 && flute_length <= 0)
    throw ParameterError(who + ": a shank diameter needs the flute length below it");
  if ((stick_out > 0) != (holder_diameter > 0))
    throw ParameterError(who + ": stick-out and holder diameter need each other");
  if (stick_out > 0 && stick_out < flute_length)
    throw ParameterError(who + ": the stick-out is shorter than the flutes");
}

std::string Tool::describe() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const bool round_end = flatRadius() <= 0.0 && corner_radius > 0.0;
  text << "T" << number << " ";
  if (!isTapered())
    text << type() << " " << diameter << " mm";
  else if (corner_radius > 0.0)
    text << "taper " << (round_end ? "ball " : "bull ") << tip_diameter << " mm";
  else
    text << "cone " << diameter << " mm";
  if (corner_radius > 0.0 && !round_end)
    text << " corner " << corner_radius << " mm";
  if (isTapered())
    text << ", " << taper << " deg";
  if (isTapered() && corner_radius > 0.0)
    text << ", to " << diameter << " mm";
  else if (tip_diameter > 0.0)
    text << ", tip " << tip_diameter << " mm";
  return text.str();
}

} // namespace pointmill
