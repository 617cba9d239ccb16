// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "template_text.h"

#include <pointmill/common/error.h>

#include <algorithm>

namespace pointmill::gcode {

namespace {

struct Place {
  std::string name;
  std::size_t width = 0;
};

[[noreturn]] void refuse(const std::string& line, const std::string& why)
{
  throw ParameterError("'" + line + "': " + why);
}

Place parsePlace(const std::string& line, const std::string& inside)
{
  const auto colon = inside.find(':');
  Place place{inside.substr(0, colon), 0};
  if (place.name.empty() ||
      place.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") != std::string::npos)
    refuse(line, "{" + inside + "} is not a place such as {tool}");
  if (colon != std::string::npos) {
    const std::string width = inside.substr(colon + 1);
    if (width.size() != 1 || width[0] < '1' || width[0] > '9')
      refuse(line, "the width in {" + inside + "} must be 1 .. 9");
    place.width = static_cast<std::size_t>(width[0] - '0');
  }
  return place;
}

/// Calls text(string) and place(Place) for the pieces of @p line in turn.
template <typename OnText, typename OnPlace>
void walk(const std::string& line, OnText&& text, OnPlace&& place)
{
  std::size_t at = 0;
  while (at < line.size()) {
    const auto brace = line.find_first_of("{}", at);
    text(line.substr(at, brace - at));
    if (brace == std::string::npos)
      return;
    const auto close = line.find_first_of("{}", brace + 1);
    if (line[brace] != '{' || close == std::string::npos || line[close] != '}')
      refuse(line, "a brace has no other one");
    place(parsePlace(line, line.substr(brace + 1, close - brace - 1)));
    at = close + 1;
  }
}

} // namespace

std::vector<std::string> placesIn(const std::string& line)
{
  std::vector<std::string> names;
  walk(
      line,
      [](const std::string&) {},
      [&](const Place& p) { names.push_back(p.name); });
  return names;
}

std::string fill(const std::string& line, const Places& places)
{
  std::string out;
  walk(
      line,
      [&](const std::string& text) { out += text; },
      [&](const Place& place) {
        const auto found =
            std::find_if(places.begin(), places.end(), [&place](const auto& p) {
              return p.first == place.name;
            });
        if (found == places.end())
          refuse(line, "{" + place.name + "} is not known here");
        const std::string& value = found->second;
        out.append(std::max(place.width, value.size()) - value.size(), '0');
        out += value;
      });
  return out;
}

} // namespace pointmill::gcode
