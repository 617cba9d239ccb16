// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/gcode/post.h>

#include "built_in_posts.h"
#include "post_keys.h"
#include "template_text.h"

#include <pointmill/common/error.h>
#include <pointmill/common/nearest_name.h>

#include <algorithm>
#include <sstream>

namespace pointmill {

using namespace gcode;

namespace {

std::string joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const auto& name : names) {
    text += text.empty() ? "" : ", ";
    text += name;
  }
  return text;
}

const std::pair<std::string, std::string>& builtIn(const std::string& name)
{
  for (const auto& post : builtInPosts())
    if (post.first == name)
      return post;
  throw ParameterError("unknown post '" + name + "'; nearest is '" +
                       nearestName(name, Post::names()) + "' of " +
                       joined(Post::names()));
}

bool contains(const std::vector<ArcPlane>& planes, ArcPlane plane)
{
  return std::find(planes.begin(), planes.end(), plane) != planes.end();
}

/// Why @p line cannot stand in a template with these places; empty: it can.
std::string
faultOf(const std::string& line, const std::vector<std::string>& places, int limit)
{
  const auto quoted = "'" + line + "'";
  if (line.find_first_not_of(' ') == std::string::npos)
    return "a line is empty";
  if (!std::all_of(
          line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; }))
    return quoted + " is not printable ASCII";
  if (static_cast<int>(line.size()) > limit)
    return quoted + " is longer than line_limit, " + std::to_string(limit);
  try {
    for (const auto& place : placesIn(line))
      if (std::find(places.begin(), places.end(), place) == places.end())
        return quoted + ": {" + place + "} is not known here; known are " +
               joined(places);
  }
  catch (const ParameterError& error) {
    return error.what();
  }
  return {};
}

void checkTemplates(const Post& post, const RefuseKey& refuse)
{
  visitTemplates(
      post, [&](const char* key, const Post::Lines& lines, const char* places) {
        std::istringstream words(std::string("program number unit control ") + places);
        std::vector<std::string> known;
        for (std::string word; words >> word;)
          known.push_back(word);
        for (const auto& line : lines)
          if (const auto fault = faultOf(line, known, post.line_limit); !fault.empty())
            refuse(key, fault);
      });
}

void checkNumbers(const Post& post, const RefuseKey& refuse)
{
  visitNumbers(post, [&](const char* key, auto value, const char* unit, Range range) {
    try {
      checkRange("post " + post.name, key, static_cast<double>(value), unit, range);
    }
    catch (const ParameterError& error) {
      refuse(key, error.what());
    }
  });
  if (post.number_start + post.number_step > post.number_max)
    refuse("number_max", "is below the second number");
}

/// What every control needs.
void checkMissing(const Post& post, const RefuseKey& refuse)
{
  const auto need = [&refuse](const char* key, const auto& value) {
    if (value.empty())
      refuse(key, "must be given");
  };
  need("name", post.name);
  need("control", post.control);
  need("extension", post.extension);
  need("comment_open", post.comment_open);
  need("comment_characters", post.comment_characters);
  need("rapid", post.rapid);
  need("feed", post.feed);
  need("tool_change", post.tool_change);
  need("coolant_on", post.coolant_on);
  need("coolant_off", post.coolant_off);
  need("approach", post.approach);
  need("dwell", post.dwell);
  need("stop", post.stop);
  need("end", post.end);
  if (post.tools == ToolChange::Pause)
    need("tool_pause", post.tool_pause);
  if (post.retract == Retract::Machine)
    need("retract_machine", post.retract_machine);
  if (post.retract == Retract::Home)
    need("retract_home", post.retract_home);
}

} // namespace

const std::vector<std::string>& Post::names()
{
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
    for (const auto& post : builtInPosts())
      list.push_back(post.first);
    return list;
  }();
  return all;
}

std::string Post::description(const std::string& name)
{
  return builtIn(name).second;
}

Post Post::named(const std::string& name)
{
  return fromText(description(name), "post " + name);
}

bool Post::takesArcs(ArcPlane plane) const
{
  return contains(arc_planes, plane);
}

bool Post::takesHelices(ArcPlane plane) const
{
  return takesArcs(plane) && contains(helix_planes, plane);
}

const Post::Lines& Post::retractLines(Retract how) const
{
  static const Lines none;
  return how == Retract::Machine ? retract_machine
         : how == Retract::Home  ? retract_home
                                 : none;
}

void Post::validate() const
{
  checkPost(*this, [this](const std::string& key, const std::string& why) {
    throw ParameterError("post '" + name + "', " + key + ": " + why);
  });
}

void gcode::checkPost(const Post& post, const RefuseKey& refuse)
{
  checkMissing(post, refuse);
  checkNumbers(post, refuse);
  checkTemplates(post, refuse);
}

} // namespace pointmill
