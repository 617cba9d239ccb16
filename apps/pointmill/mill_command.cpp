// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"

#include "keep_out_option.h"
#include "option.h"

#include <pointmill/common/cutting_data.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/mill/result.h>
#include <pointmill/mill/summary.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

using namespace pointmill;

namespace {

void declareJob(CLI::App& app, const std::string& what, ToolOptions& tool, ToolJob& job)
{
  const std::string group = what + ", T" + std::to_string(job.tool.number);
  tool.declare(app, group, job.tool);
  const auto add =
      [&](const char* option, double& value, const char* unit, const char* help) {
        numberOption(app, "--" + tool.name + option, value, unit, help)->group(group);
      };
  add("-allowance", job.allowance, "MM", "material to leave on the part");
  add("-spindle", job.cutting.spindle, "RPM", "spindle speed");
  add("-feed", job.cutting.feed, "MM/MIN", "feed along the path");
  add("-plunge-feed", job.cutting.plunge_feed, "MM/MIN", "fastest feed downwards");
}

} // namespace

CLI::App* declareMill(CLI::App& app, MillCommand& command)
{
  MillOptions& o = command.options;
  CLI::App* mill = app.add_subcommand(
      "mill", "turn a scan into a verified NC program with its picture and report");
  command.app = mill;
  mill->add_option(
          "SCAN", command.scan, "PCD, PLY, OBJ, STL or text (XYZ, ASC, PTS, CSV)")
      ->required();
  mill->add_option(
          "-o,--output", command.directory, "directory; default: SCAN's name + _nc")
      ->type_name("DIR");
  command.output.declareQuiet(*mill);
  command.output.declareJson(*mill);

  declareScan(*mill, command);
  declareAccuracy(*mill, command);
  declareSetUp(*mill, command);
  declareMachine(*mill, command);
  declareOperations(*mill, command);
  declareProgram(*mill, command);
  declareJob(*mill, "Roughing", command.rough_tool, o.rough);
  declareJob(*mill, "Semi-finishing", command.semi_tool, o.semi);
  declareJob(*mill, "Finishing", command.finish_tool, o.finish);
  return mill;
}

namespace {

Stock boxOf(const std::vector<double>& b)
{
  return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
}

/// Speeds and feeds for the material, but those that were given.
void setCutting(MillOptions& o, const MillCommand& command)
{
  const WorkMaterial& material = workMaterial(command.material);
  if (o.machine.max_spindle <= 0)
    throw ParameterError("mill: --material needs --max-spindle: small tools in soft "
                         "material would turn faster than any spindle");
  const auto set = [&](const ToolOptions& said, ToolJob& job, CutKind kind) {
    CutSetting cut;
    cut.material = material;
    cut.tool = job.tool;
    cut.kind = kind;
    if (kind == CutKind::Roughing) {
      cut.depth = o.stepDown();
      cut.width = o.stepOver();
    }
    const Cutting found = cuttingFor(cut, o.machine);
    const auto take = [&](const char* option, double& value, double better) {
      if (command.app->count("--" + said.name + option) == 0)
        value = better;
    };
    take("-spindle", job.cutting.spindle, found.spindle);
    take("-feed", job.cutting.feed, found.feed);
    take("-plunge-feed", job.cutting.plunge_feed, found.plunge_feed);
    job.cutting.coolant = found.coolant;
  };
  set(command.rough_tool, o.rough, CutKind::Roughing);
  set(command.semi_tool, o.semi, CutKind::Finishing);
  set(command.finish_tool, o.finish, CutKind::Finishing);
}

/// What the options hold that is not said word by word.
void completeOptions(MillCommand& command)
{
  MillOptions& o = command.options;
  o.square = !command.no_square;
  o.remove_strays = !command.keep_strays;
  o.arcs = !command.no_arcs;
  for (const auto& [x, y] : command.through_holes)
    o.through_holes.emplace_back(x, y);
  if (command.polygon.size() % 2 != 0)
    throw ParameterError("--polygon: X and Y in turn, not an odd number of numbers");
  for (std::size_t i = 0; i + 1 < command.polygon.size(); i += 2)
    o.boundary.emplace_back(command.polygon[i], command.polygon[i + 1]);
  o.rough.tool = command.rough_tool.toolFrom(o.rough.tool);
  o.semi.tool = command.semi_tool.toolFrom(o.semi.tool);
  o.finish.tool = command.finish_tool.toolFrom(o.finish.tool);
  if (!command.stock_box.empty())
    o.stock_box = boxOf(command.stock_box);
  if (!command.travel.empty())
    o.machine.travel = boxOf(command.travel);
  o.keep_out = readKeepOut(command.keep_out, command.keep_out_margin);
  if (!command.material.empty())
    setCutting(o, command);
  if (command.no_coolant)
    for (auto* job : {&o.rough, &o.semi, &o.finish})
      job->cutting.coolant = false;
  if (command.rest_diameter) {
    o.rest = o.rough; // its feeds and allowance
    o.rest->tool = Tool::flat(4, *command.rest_diameter);
  }
}

} // namespace

int runMill(MillCommand& command, const Watch& watch)
{
  completeOptions(command);
  const MillOptions& o = command.options;
  if (command.directory.empty())
    command.directory = std::filesystem::path(command.scan).stem().string() + "_nc";

  MillJob::checkDirectory(command.scan, command.directory);
  MillJob job(o);
  std::optional<ShownProgress> shown(std::in_place, watch, command.output);
  try {
    job.plan(command.scan);
  }
  catch (const VerificationError& e) {
    job.writeRefusal(command.directory);
    const std::string why =
        std::string(e.what()) + "\n" +
        (std::filesystem::path(command.directory) / "refused.png").string() +
        " shows it" +
        (job.earlierProgram() ? "; the program of an earlier job was renamed" : "");
    shown.reset();
    if (!command.output.json)
      throw VerificationError(why);
    return writeError(
        3, "refused", why, Json::parse(resultJson(job, command.directory)));
  }
  job.write(command.directory);
  shown.reset();
  if (command.output.json)
    writeResult(0,
                job.verification().good() ? "passed" : "forced",
                Json::parse(resultJson(job, command.directory)));
  else if (!command.output.quiet)
    std::cout << forPeople(summaryOf(job, command.directory));
  return 0;
}
