// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "scene_texts.h"

#include "shapes.h"
#include "stock_surface.h"
#include "words.h"

#include <algorithm>
#include <cstdio>

namespace pointmill::viewer {

namespace {

Legend stockLegend(const ViewerScene& scene)
{
  Legend cut{"cut last by", {}, false};
  for (const auto& section : scene.sections) {
    const LegendEntry entry{surfaceColour(section.colour), section.name};
    if (std::none_of(cut.entries.begin(), cut.entries.end(), [&](const auto& known) {
          return known.text == entry.text && same(known.colour, entry.colour);
        }))
      cut.entries.push_back(entry);
  }
  cut.entries.push_back({visual::kRawStock, "stock, not cut"});
  return cut;
}

Legend heightLegend(const pcl::PointCloud<pcl::PointXYZ>& part)
{
  const auto [low, high] = heightsOf(part);
  Legend bar{"height, mm", {}, true};
  constexpr int steps = 4;
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / steps;
    bar.entries.push_back(
        {visual::heightColour(share), numberText(low + share * (high - low))});
  }
  return bar;
}

} // namespace

std::string momentText(const ViewerScene& scene,
                       const std::vector<double>& levels,
                       const ViewerLook& look)
{
  std::string text;
  if (look.finding && *look.finding < scene.findings.size())
    text += std::to_string(*look.finding + 1) + " of " +
            std::to_string(scene.findings.size()) + ": " +
            scene.findings[*look.finding].text + "\n";
  if (look.level && *look.level < levels.size() &&
      (look.map || look.paths == ViewedPaths::Level))
    text += "level " + std::to_string(*look.level + 1) + " of " +
            std::to_string(levels.size()) + ", Z" + numberText(levels[*look.level]) +
            "\n";
  if (!scene.player || scene.player->program().moves.empty())
    return text;
  const CutPlayer& player = *scene.player;
  const Program& program = player.program();
  const ProgramMove& move = program.moves[player.move()];
  text += clockText(player.time()) + " of " + clockText(player.duration());
  if (look.playing)
    text += (*look.playing ? "   playing x" : "   stopped x") + numberText(look.speed);
  text += "   " + program.where(move.line);
  if (player.sectionOf(player.move()) < program.sections.size())
    text += "   " + program.sections[player.sectionOf(player.move())].name;
  if (const Tool* tool = player.tool())
    text += "   " + tool->describe();
  const Eigen::Vector3d tip = player.tip();
  if (tip.allFinite()) {
    char place[96];
    std::snprintf(
        place, sizeof place, "\nX%.3f Y%.3f Z%.3f", tip.x(), tip.y(), tip.z());
    text += place;
  }
  else
    text += "\nabove everything";
  text += move.rapid ? "   rapid" : "   F" + numberText(move.feed);
  return text;
}

std::vector<Legend> legendsOf(const ViewerScene& scene,
                              const ViewerLook& look,
                              const visual::DeviationScale& scale)
{
  std::vector<Legend> legends;
  const bool paths = scene.path && (look.paths == ViewedPaths::All ||
                                    look.paths == ViewedPaths::Level);
  const bool stock = look.solid == ViewedSolid::Stock && scene.player && !look.map;
  if (paths) {
    const PathColours colours(scene, look.colouring);
    legends.push_back({colours.title(), colours.legend(), colours.isGradual()});
    if (look.rapids && !colours.isGradual())
      legends.back().entries.push_back({visual::kFaintInk, "rapids, dashed"});
  }
  if (stock)
    legends.push_back(stockLegend(scene));
  if (look.solid == ViewedSolid::Part && scene.part && !look.map)
    legends.push_back(heightLegend(*scene.part));
  if (look.solid == ViewedSolid::Deviation && scene.deviation) {
    Legend bar{"deviation, mm", {}, true};
    const double t = scale.tolerance, end = scale.range;
    const auto entry = [&](double at, const std::string& words) {
      bar.entries.push_back({scale.at(at), words});
    };
    // The colours jump at the tolerance.
    entry(-end, numberText(-end) + " too deep");
    entry(-t * 1.001, "");
    entry(-t * 0.999, numberText(-t));
    entry(0, "0");
    entry(t * 0.999, "+" + numberText(t));
    entry(t * 1.001, "");
    entry(end, "+" + numberText(end) + " left");
    legends.push_back(std::move(bar));
    legends.push_back({"", {{visual::kNeverCut, "no tool came"}}, false});
  }
  if (look.map && scene.map && look.level)
    legends.push_back(
        {"map",
         {{sheetColour(visual::OccupancyKind::Occupied), "part"},
          {sheetColour(visual::OccupancyKind::Free), "free"},
          {sheetColour(visual::OccupancyKind::Protected), "gap, protected"}},
         false});
  return legends;
}

} // namespace pointmill::viewer
