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
  checkRange(who, "corner radius", corner_radius, "mm", {0, radius()});
  checkRange(who, "flutes", flutes, "", {1, 20});
}

std::string Tool::describe() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "T" << number << " " << type() << " " << diameter << " mm";
  if (!isFlat() && !isBall())
    text << " corner " << corner_radius << " mm";
  return text.str();
}

} // namespace pointmill
