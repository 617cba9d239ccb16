// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "view_field.h"
#include "view_path.h"

#include <pointmill/page/html.h>
#include <pointmill/page/view_scene.h>
#include <pointmill/visual/deviation_picture.h>
#include <pointmill/visual/palette.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kColours = 64; ///< of a scale, and one more

Json of(const Eigen::Vector3d& v)
{
  return {v.x(), v.y(), v.z()};
}

Json of(const PackedField& field)
{
  return {{"low", field.low}, {"step", field.step}, {"values", base64(field.bytes)}};
}

CellGrid gridOver(const Stock& stock, const ViewScene& scene, int cells)
{
  const Eigen::Vector2d size = (stock.max - stock.min).head<2>();
  double finest = std::numeric_limits<double>::infinity();
  for (const auto* field : {scene.part, scene.milled})
    if (field)
      finest = std::min(finest, CellGrid::of(*field).cell);
  const double most = size.maxCoeff() / cells;
  const double cell = std::isfinite(finest) ? std::max(finest, most) : most;
  return CellGrid::covering(stock.min.head<2>(), stock.max.head<2>(), cell);
}

Json fieldsOf(const ViewScene& scene, int cells)
{
  const CellGrid grid = gridOver(scene.stock, scene, cells);
  Json json = {{"columns", grid.columns},
               {"rows", grid.rows},
               {"x", grid.x(0)},
               {"y", grid.y(0)},
               {"cell", grid.cell}};
  const auto add = [&](const char* name, const CellCloud* field) {
    if (field)
      json[name] = of(packed(heightsAt(grid, *field),
                             std::min(scene.stock.min.z(), scene.stock.max.z()),
                             scene.stock.max.z()));
  };
  add("part", scene.part);
  add("milled", scene.milled);
  Json colours = Json::array();
  for (int i = 0; i <= kColours; ++i)
    colours.push_back(heightColour(double(i) / kColours));
  json["height_colours"] = colours;
  if (!scene.deviation)
    return json;
  const double range = deviationRange(*scene.deviation, scene.tolerance);
  json["deviation"] = of(packed(extremesIn(grid, *scene.deviation), -range, range));
  json["deviation"]["range"] = range;
  json["deviation"]["tolerance"] = scene.tolerance;
  json["deviation"]["none"] = neverCutColour();
  for (int i = 0; i <= kColours; ++i)
    json["deviation"]["colours"].push_back(
        deviationColour((2.0 * i / kColours - 1) * range, scene.tolerance, range));
  return json;
}

Json pathsOf(const ViewScene& scene, const ViewLimits& limits)
{
  std::vector<Strokes> all;
  double start = 0;
  for (const auto& path : scene.paths) {
    all.push_back(strokesOf(*scene.program, path, start, scene.rapid_rate));
    start += path.seconds;
  }
  const double diagonal = (scene.stock.max - scene.stock.min).norm();
  double off = diagonal / limits.chords;
  std::vector<Strokes> drawn;
  for (bool again = true; again; off *= again ? 1.5 : 1) {
    std::size_t corners = 0;
    drawn.assign(all.size(), {});
    const auto take = [&](const std::vector<Stroke>& from, std::vector<Stroke>& to) {
      for (const auto& stroke : from) {
        to.push_back(simplified(stroke, off));
        corners += to.back().size();
      }
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      take(all[i].feeds, drawn[i].feeds);
      take(all[i].rapids, drawn[i].rapids);
    }
    again = corners > limits.corners && off < diagonal / 10;
  }
  const double step = off / 4;
  Json list = Json::array();
  start = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ViewPath& path = scene.paths[i];
    list.push_back({{"label", path.label},
                    {"colour", operationColour(path.colour)},
                    {"tool", path.tool},
                    {"start", start},
                    {"seconds", path.seconds},
                    {"feeds", base64(packed(drawn[i].feeds, step))},
                    {"rapids", base64(packed(drawn[i].rapids, step))}});
    start += path.seconds;
  }
  return {{"off", off}, {"step", step}, {"seconds", start}, {"list", list}};
}

/// The outline of each tool, radius and height over the tip in turn.
Json toolsOf(const std::vector<Tool>& tools)
{
  constexpr int steps = 16;
  Json list = Json::array();
  for (const auto& tool : tools) {
    Json outline = Json::array();
    for (int i = 0; i <= steps; ++i) {
      // Denser where a round end rises.
      const double r = tool.radius() * std::sin(M_PI / 2 * i / steps);
      outline.push_back({r, tool.profile(std::min(r, tool.radius()))});
    }
    list.push_back({{"number", tool.number}, {"outline", outline}});
  }
  return list;
}

Json zonesOf(const KeepOut& keep_out)
{
  Json list = Json::array();
  for (const auto& zone : keep_out.zones()) {
    Json corners = Json::array();
    for (const auto& c : zone.corners())
      corners.push_back({c.x(), c.y()});
    list.push_back(
        {{"corners", corners}, {"radius", zone.radius()}, {"top", zone.top()}});
  }
  return list;
}

} // namespace

std::string viewJson(const ViewScene& scene, const ViewLimits& limits)
{
  Json json = {{"min", of(scene.stock.min)},
               {"max", of(scene.stock.max)},
               {"clearance", scene.clearance},
               {"fields", fieldsOf(scene, limits.cells)},
               {"tools", toolsOf(scene.tools)},
               {"zones", scene.keep_out ? zonesOf(*scene.keep_out) : Json::array()}};
  if (scene.program)
    json["paths"] = pathsOf(scene, limits);
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // "</script>" in a name must not end the script.
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text)
    c == '<' ? safe += "\\u003c" : safe += c;
  return safe;
}

} // namespace pointmill
