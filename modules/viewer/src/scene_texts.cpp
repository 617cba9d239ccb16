// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "scene_texts.h"

#include "words.h"

#include <cstdio>

namespace pointmill::viewer {

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
  const bool stock = look.solid == ViewedSolid::Stock && scene.player;
  if (paths) {
    const PathColours colours(scene, look.colouring);
    legends.push_back({colours.title(), colours.legend(), colours.isGradual()});
    if (look.rapids && !colours.isGradual())
      legends.back().entries.push_back({visual::kFaintInk, "rapids, dashed"});
  }
  if (stock && !(paths && look.colouring == PathColouring::Operation)) {
    Legend cut{"cut last by", {}, false};
    for (const auto& o : scene.operations)
      cut.entries.push_back(
          {visual::mix(visual::kOperations[o.colour % visual::kOperationCount],
                       visual::kPage,
                       0.42f),
           o.name});
    cut.entries.push_back({visual::kRawStock, "stock, not cut"});
    legends.push_back(std::move(cut));
  }
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
    legends.push_back({"map",
                       {{visual::kOccupied, "part"},
                        {visual::kFree, "free"},
                        {visual::kProtected, "gap, protected"}},
                       false});
  return legends;
}

} // namespace pointmill::viewer
