// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"

#include "keep_out_option.h"

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
        app.add_option("--" + tool.name + option, value, help)
            ->type_name(unit)
            ->capture_default_str()
            ->group(group);
      };
  add("-allowance", job.allowance, "MM", "material to leave on the part");
  add("-spindle", job.cutting.spindle, "RPM", "spindle speed");
  add("-feed", job.cutting.feed, "MM/MIN", "feed along the path");
  add("-plunge-feed", job.cutting.plunge_feed, "MM/MIN", "fastest feed downwards");
}

/// An option that takes one of a few names.
template <typename Value>
CLI::Option* choice(CLI::App& app,
                    const std::string& name,
                    Value& value,
                    const std::vector<std::pair<std::string, Value>>& choices,
                    const std::string& help)
{
  std::string names;
  for (const auto& c : choices)
    names += (names.empty() ? "" : "|") + c.first;
  return app
      .add_option_function<std::string>(
          name,
          [=, &value](const std::string& given) {
            for (const auto& c : choices)
              if (c.first == given) {
                value = c.second;
                return;
              }
            throw CLI::ValidationError(name, "must be " + names + ", not " + given);
          },
          help)
      ->type_name(names);
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

  CLI::Option* units_option =
      choice(*mill,
             "--units",
             o.mm_per_unit,
             {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}},
             "the scan's units")
          ->default_str("mm")
          ->group("Scan");
  mill->add_option(
          "--scale", o.mm_per_unit, "mm per unit of the scan, instead of --units")
      ->type_name("S")
      ->excludes(units_option)
      ->group("Scan");
  mill->add_option("--fit", o.fit, "scale so that the largest extent is this")
      ->type_name("MM")
      ->group("Scan");
  choice(*mill,
         "--up",
         o.up,
         {{"x", Up::X},
          {"-x", Up::MinusX},
          {"y", Up::Y},
          {"-y", Up::MinusY},
          {"z", Up::Z},
          {"-z", Up::MinusZ},
          {"plane", Up::Plane},
          {"pca", Up::Pca}},
         "direction of the scan that the tool comes from (--up=-z)")
      ->default_str("z")
      ->group("Scan");
  mill->add_flag("--no-square", command.no_square, "do not turn the long side to X")
      ->group("Scan");
  choice(*mill,
         "--datum",
         o.datum_xy,
         {{"corner", DatumXY::Corner}, {"centre", DatumXY::Centre}},
         "X0 Y0 of the part's bounding box")
      ->default_str("corner")
      ->group("Scan");
  choice(*mill,
         "--datum-z",
         o.datum_z,
         {{"top", DatumZ::Top}, {"bottom", DatumZ::Bottom}},
         "Z0 of the part's bounding box")
      ->default_str("top")
      ->group("Scan");
  mill->add_flag(
          "--keep-strays", command.keep_strays, "keep points that have no company")
      ->group("Scan");
  choice(*mill,
         "--gaps",
         o.gaps,
         {{"bridge", GapPolicy::Bridge},
          {"keep", GapPolicy::Keep},
          {"mill", GapPolicy::Mill}},
         "holes of the scan: bridged from their rim and not cut below, "
         "left standing, or milled like the outside")
      ->default_str("bridge")
      ->group("Scan");
  mill->add_option(
          "--through-hole",
          command.through_holes,
          "a place of the part frame in a gap that is a hole through the part: "
          "milled, whatever --gaps says; may be repeated")
      ->type_name("X Y")
      ->type_size(2)
      ->expected(-1)
      ->group("Scan");
  mill->add_option("--seed", o.seed, "of all random sampling")
      ->capture_default_str()
      ->group("Scan");

  const auto add = [&](const char* name,
                       double& value,
                       const char* unit,
                       const char* help,
                       const char* group) {
    mill->add_option(name, value, help)
        ->type_name(unit)
        ->capture_default_str()
        ->group(group);
  };
  add("--tolerance",
      o.tolerance,
      "MM",
      "deepest gouge, all errors together",
      "Accuracy");
  add("--scallop", o.scallop, "MM", "scallop height of the finishing", "Accuracy");
  add("--semi-scallop",
      o.semi_scallop,
      "MM",
      "scallop height of the semi-finishing",
      "Accuracy");
  choice(*mill,
         "--surface",
         o.surface,
         {{"auto", SurfaceChoice::Auto},
          {"points", SurfaceChoice::Points},
          {"smooth", SurfaceChoice::Smooth}},
         "what the cutters rest on: the bare points, or a smooth surface between them "
         "with the noise taken off; auto: by spacing, noise and tolerance")
      ->default_str("auto")
      ->group("Accuracy");
  mill->add_option("--noise",
                   o.noise,
                   "the scanner's, a standard deviation; 0: none, so that no point is "
                   "moved")
      ->type_name("MM")
      ->default_str("measured")
      ->group("Accuracy");
  mill->add_flag("--accept-sparse",
                 o.accept_sparse,
                 "go on where tools sink more than the tolerance between bare points")
      ->group("Accuracy");
  add("--cell",
      o.cell,
      "MM",
      "edge of a map cell; 0: a twentieth of the roughing tool",
      "Accuracy");
  add("--residual-limit",
      o.residual_limit,
      "MM",
      "refuse where half of the points keep more",
      "Accuracy");
  add("--clearance",
      o.clearance,
      "MM",
      "of the clearance plane above the stock and all zones",
      "Machine and stock");
  add("--rapid-rate",
      o.machine.rapid_rate,
      "MM/MIN",
      "for the time estimate",
      "Machine and stock");
  add("--stock-margin",
      o.stock_margin,
      "MM",
      "stock beyond the part on each side",
      "Machine and stock");
  add("--stock-top", o.stock_top, "MM", "stock above the part", "Machine and stock");
  add("--stock-bottom",
      o.stock_bottom,
      "MM",
      "stock below the part",
      "Machine and stock");
  mill->add_option("--stock-box",
                   command.stock_box,
                   "the stock in the part frame, instead of margins round the part")
      ->type_name("X0 Y0 Z0 X1 Y1 Z1")
      ->expected(6)
      ->group("Machine and stock");
  mill->add_option(
          "--stock-scan",
          o.stock_scan,
          "scan of the raw part, a casting say, in the frame and units of SCAN")
      ->type_name("FILE")
      ->group("Machine and stock");
  mill->add_option("--floor", o.floor, "no tip goes below this Z of the part frame")
      ->type_name("MM")
      ->default_str("the part's lowest point")
      ->group("Machine and stock");
  mill->add_flag("--no-coolant", command.no_coolant, "no M8")
      ->group("Machine and stock");
  choice(*mill,
         "--roughing",
         o.roughing,
         {{"grid", RoughingStrategy::Grid},
          {"zigzag", RoughingStrategy::ZigZag},
          {"spiral", RoughingStrategy::Spiral},
          {"high-speed", RoughingStrategy::HighSpeed},
          {"offset", RoughingStrategy::Offset}},
         "how the roughing goes over a level")
      ->default_str("offset")
      ->group("Operations");
  add("--step-down", o.step_down, "MM", "of the roughing; 0: 0.3 d / 4", "Operations");
  add("--step-over", o.step_over, "MM", "of the roughing; 0: 0.4 d", "Operations");
  mill->add_option("--keep-out",
                   command.keep_out,
                   std::string("where no tool may be, a clamp: ") + kKeepOutSyntax +
                       "; may be repeated")
      ->type_name("ZONE")
      ->group("Machine and stock");
  add("--keep-out-margin",
      command.keep_out_margin,
      "MM",
      "that tools keep from such zones",
      "Machine and stock");
  mill->add_option("--rest-tool",
                   command.rest_diameter,
                   "diameter of a flat end mill, T4, that cuts what the roughing tool "
                   "left before the ball end mills do")
      ->type_name("MM")
      ->group("Operations");
  mill->add_option("--min-flat",
                   o.min_flat,
                   "smallest level ground that gets a level of the roughing; 0: none")
      ->type_name("MM2")
      ->default_str("the diameter of the tool's end squared")
      ->group("Operations");
  choice(*mill,
         "--raster",
         o.raster,
         {{"x", RasterDirection::AlongX},
          {"y", RasterDirection::AlongY},
          {"auto", RasterDirection::Auto}},
         "the finishing rows run along; auto: whichever is milled sooner")
      ->default_str("auto")
      ->group("Operations");
  choice(*mill,
         "--pattern",
         o.pattern,
         {{"zigzag", RasterPattern::ZigZag}, {"one-way", RasterPattern::OneWay}},
         "how the finishing rows follow each other")
      ->default_str("zigzag")
      ->group("Operations");
  choice(*mill,
         "--milling",
         o.milling,
         {{"climb", MillingMode::Climb}, {"conventional", MillingMode::Conventional}},
         "of one-way rows, for a spindle that turns clockwise")
      ->default_str("climb")
      ->group("Operations");
  choice(*mill,
         "--boundary",
         o.over_stock,
         {{"part", false}, {"stock", true}},
         "finishing goes wherever the cutter touches the part, or keeps its axis over "
         "the stock")
      ->default_str("part")
      ->group("Operations");
  mill->add_option("--polygon",
                   command.polygon,
                   "finishing keeps the tool's axis inside this polygon of the part "
                   "frame")
      ->type_name("X Y X Y X Y ...")
      ->expected(6, 20000)
      ->group("Operations");
  add("--overhang",
      o.overhang,
      "MM",
      "how far beyond stock or polygon the axis may go; negative: inside",
      "Operations");
  mill->add_option("--threads", o.threads, "0: all of the machine")
      ->capture_default_str()
      ->group("Operations");
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
