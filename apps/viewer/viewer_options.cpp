// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "viewer_options.h"

#include "../options/pcl_look.h"
#include "../pointmill/option.h"

#include <pointmill/common/error.h>
#include <pointmill/viewer/add_cloud.h>

#include <algorithm>
#include <sstream>

using namespace pointmill;

namespace {

const std::vector<std::pair<std::string, ViewedSolid>> kSolids = {
    {"stock", ViewedSolid::Stock},
    {"part", ViewedSolid::Part},
    {"deviation", ViewedSolid::Deviation},
    {"none", ViewedSolid::None}};
const std::vector<std::pair<std::string, ViewedPaths>> kPaths = {
    {"all", ViewedPaths::All},
    {"level", ViewedPaths::Level},
    {"trail", ViewedPaths::Trail},
    {"none", ViewedPaths::None}};
const std::vector<std::pair<std::string, PathColouring>> kColourings = {
    {"operation", PathColouring::Operation},
    {"pass", PathColouring::Pass},
    {"level", PathColouring::Level},
    {"motion", PathColouring::Motion},
    {"feed", PathColouring::Feed},
    {"height", PathColouring::Height}};
const std::vector<std::pair<std::string, ViewedFrom>> kFrom = {
    {"iso", ViewedFrom::Iso},
    {"top", ViewedFrom::Top},
    {"front", ViewedFrom::Front},
    {"back", ViewedFrom::Back},
    {"left", ViewedFrom::Left},
    {"right", ViewedFrom::Right}};

/// "1280x800"
void setSize(ViewerOptions& options, const std::string& text)
{
  char between = 0;
  std::istringstream in(text);
  if (!(in >> options.width >> between >> options.height) || between != 'x' ||
      !(in >> std::ws).eof() || options.width < 64 || options.height < 64 ||
      options.width > 8192 || options.height > 8192)
    throw CLI::ValidationError("--size",
                               "WIDTHxHEIGHT in px, 64 .. 8192 each, not " + text);
}

std::optional<std::size_t> wholeNumber(const std::string& text)
{
  std::istringstream in(text);
  std::size_t number = 0;
  if (text.empty() || text[0] < '0' || text[0] > '9' || !(in >> number) ||
      in.peek() != EOF)
    return std::nullopt;
  return number;
}

/// "90", "1:30", "0:01:30", "50%" or "line 123"
double momentOf(const std::string& text, const ViewerScene& scene)
{
  if (!scene.player || scene.player->duration() <= 0)
    throw ParameterError("pointmill_viewer: --at needs a program");
  const CutPlayer& player = *scene.player;
  const auto bad = [&]() -> double {
    throw ParameterError("pointmill_viewer: --at takes seconds, h:mm:ss, a share as "
                         "50% or \"line 123\", not " +
                         text);
  };
  if (text.rfind("line", 0) == 0) {
    const auto line = wholeNumber(text.substr(text.find_first_not_of("line ")));
    if (!line || *line < 1 || *line > player.program().lines)
      throw ParameterError("pointmill_viewer: --at: the program has lines 1 .. " +
                           std::to_string(player.program().lines));
    return player.endOf(player.moveOfLine(*line));
  }
  std::istringstream in(text);
  double seconds = 0, number = 0;
  for (int parts = 1; parts <= 3 && in >> number; ++parts) {
    if (number < 0 || (parts > 1 && number >= 60))
      break;
    seconds = 60 * seconds + number;
    const int next = in.get();
    if (next == EOF && seconds <= player.duration())
      return seconds;
    if (next == '%' && in.peek() == EOF && parts == 1 && number <= 100)
      return player.duration() * number / 100;
    if (next != ':')
      break;
  }
  return bad();
}

template <typename Value>
void optionalChoice(CLI::App& app,
                    const std::string& name,
                    std::optional<Value>& value,
                    const std::vector<std::pair<std::string, Value>>& choices,
                    const std::string& help)
{
  choice<Value>(
      app, name, [&value](Value v) { value = v; }, choices, help);
}

} // namespace

void declare(CLI::App& app, ViewerOptions& o)
{
  app.add_option("INPUT", o.inputs, "directory of a job, and clouds or meshes")
      ->required();
  app.add_option("--program",
                 o.programs,
                 "play and judge this program instead of the job's own; its files in "
                 "the order of machining")
      ->type_name("FILE");
  app.add_option("--scan", o.scan, "show the scan that the job was made from as well")
      ->type_name("FILE");
  optionalChoice(app, "--solid", o.solid, kSolids, "what stands in the middle");
  optionalChoice(app, "--paths", o.paths, kPaths, "which paths are shown");
  optionalChoice(
      app, "--colour-by", o.colouring, kColourings, "what the colours of paths tell");
  app.add_option("--level", o.level, "the level that is shown, 1 at the top")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  app.add_flag("--map", o.map, "show the bi-colour map at that level");
  app.add_option("--finding", o.finding, "look at this finding, from 1 on")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  app.add_option("--at", o.at, "moment: seconds, h:mm:ss, a share as 50%, \"line 123\"")
      ->type_name("TIME");
  CLI::Option* play = app.add_flag("--play", o.play, "play from there");
  numberOption(app, "--speed", o.look.speed, "X", "so much faster than the machine")
      ->default_str("all of it in a minute")
      ->check(CLI::Range(0.01, 1e5));
  app.add_flag("--no-rapids", o.no_rapids, "hide rapids");
  app.add_flag("--no-tool", o.no_tool, "hide the tool");
  app.add_flag("--no-box", o.no_box, "hide the box of the stock");
  app.add_flag("--no-texts", o.no_texts, "hide title, legend and figures");
  app.add_flag("--no-axes", o.no_axes, "hide the axes of the part frame");
  app.add_flag("-q,--quiet", o.quiet, "do not tell how far it is");
  app.add_option("--screenshot", o.screenshot, "write a picture; needs no display")
      ->type_name("PNG")
      ->check([](const std::string& name) {
        const bool png = name.size() > 4 && name.substr(name.size() - 4) == ".png";
        return png ? std::string() : name + ": pictures are .png";
      })
      ->excludes(play);
  choice<ViewedFrom>(
      app,
      "--view",
      [&o](ViewedFrom from) { o.look.from = from; },
      kFrom,
      "where it is looked at from")
      ->default_str("iso");
  app.add_option_function<std::string>(
         "--size", [&o](const std::string& text) { setSize(o, text); }, "of the window")
      ->type_name("WxH")
      ->default_str("1280x800");
  declarePclLook(app, o.look);
}

ViewerLook lookOf(const ViewerOptions& o, const ViewerScene& scene)
{
  ViewerLook look = o.look;
  const ViewerLook suited = lookFor(scene);
  look.colouring = o.colouring ? *o.colouring : suited.colouring;
  look.map = o.map || (suited.map && !scene.player);
  look.level = suited.level;
  look.solid = o.solid        ? *o.solid
               : scene.player ? ViewedSolid::Stock
                              : ViewedSolid::Part;
  look.paths = o.paths        ? *o.paths
               : scene.player ? ViewedPaths::Trail
                              : ViewedPaths::All;
  look.rapids = !o.no_rapids;
  look.tool = !o.no_tool;
  look.box = !o.no_box;
  look.texts = !o.no_texts;
  if (o.no_axes)
    look.axes = -1;
  if (o.level)
    look.level = *o.level - 1;
  if (o.finding && *o.finding > scene.findings.size())
    throw ParameterError("pointmill_viewer: there is no finding " +
                         std::to_string(*o.finding) + "; there are " +
                         std::to_string(scene.findings.size()));
  if (o.finding)
    look.finding = *o.finding - 1;
  if (!o.at.empty())
    look.time = momentOf(o.at, scene);
  else if (scene.player && !o.play)
    look.time = scene.player->duration();
  return look;
}
