// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"

#include "keep_out_option.h"
#include "option.h"

#include <pointmill/mill/mill_job.h>
#include <pointmill/mill/summary.h>

#include <boost/timer/progress_display.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <unistd.h>
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

volatile std::sig_atomic_t interrupted = 0;

/// A bar on the terminal for what takes over a second.
class Bar {
public:
  void operator()(const std::string&, double done)
  {
    const std::chrono::duration<double> since =
        std::chrono::steady_clock::now() - start_;
    if (!bar_ && since.count() > 1.0)
      bar_ = std::make_unique<boost::timer::progress_display>(100, std::cerr);
    if (bar_)
      *bar_ += static_cast<unsigned long>(100 * done) - bar_->count();
  }
  void finish() { (*this)("", 1.0); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::unique_ptr<boost::timer::progress_display> bar_;
};

} // namespace

CLI::App* declareMill(CLI::App& app, MillCommand& command)
{
  MillOptions& o = command.options;
  CLI::App* mill = app.add_subcommand(
      "mill", "turn a scan into a verified NC program with its picture and report");
  mill->add_option(
          "SCAN", command.scan, "PCD, PLY, OBJ, STL or text (XYZ, ASC, PTS, CSV)")
      ->required();
  mill->add_option(
          "-o,--output", command.directory, "directory; default: SCAN's name + _nc")
      ->type_name("DIR");
  mill->add_flag("-q,--quiet", command.quiet, "print nothing but errors");

  declareScan(*mill, command);
  declareAccuracy(*mill, command);
  declareSetUp(*mill, command);
  declareOperations(*mill, command);
  declareJob(*mill, "Roughing", command.rough_tool, o.rough);
  declareJob(*mill, "Semi-finishing", command.semi_tool, o.semi);
  declareJob(*mill, "Finishing", command.finish_tool, o.finish);
  return mill;
}

int runMill(MillCommand& command)
{
  MillOptions& o = command.options;
  o.square = !command.no_square;
  o.remove_strays = !command.keep_strays;
  for (const auto& [x, y] : command.through_holes)
    o.through_holes.emplace_back(x, y);
  if (command.polygon.size() % 2 != 0)
    throw ParameterError("--polygon: X and Y in turn, not an odd number of numbers");
  for (std::size_t i = 0; i + 1 < command.polygon.size(); i += 2)
    o.boundary.emplace_back(command.polygon[i], command.polygon[i + 1]);
  o.rough.tool = command.rough_tool.toolFrom(o.rough.tool);
  o.semi.tool = command.semi_tool.toolFrom(o.semi.tool);
  o.finish.tool = command.finish_tool.toolFrom(o.finish.tool);
  if (!command.stock_box.empty()) {
    const auto& b = command.stock_box;
    o.stock_box = Stock{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }
  o.keep_out = readKeepOut(command.keep_out, command.keep_out_margin);
  if (command.rest_diameter) {
    o.rest = o.rough; // its feeds and allowance
    o.rest->tool = Tool::flat(4, *command.rest_diameter);
    o.rest->cutting.coolant = !command.no_coolant;
  }
  for (auto* job : {&o.rough, &o.semi, &o.finish})
    job->cutting.coolant = !command.no_coolant;
  if (command.directory.empty())
    command.directory = std::filesystem::path(command.scan).stem().string() + "_nc";

  MillJob::checkDirectory(command.scan, command.directory);
  MillJob job(o);
  Bar bar;
  const bool shown = !command.quiet && isatty(STDERR_FILENO);
  const auto stop = [](int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL); // the second one stops at once
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  job.setProgress([&](const std::string& stage, double done) {
    if (interrupted) // between two stages, so that nothing stays half written
      throw Interrupted();
    if (shown)
      bar(stage, done);
  });
  job.plan(command.scan);
  job.write(command.directory);
  if (shown)
    bar.finish();
  if (!command.quiet)
    std::cout << summaryOf(job, command.directory);
  return 0;
}
