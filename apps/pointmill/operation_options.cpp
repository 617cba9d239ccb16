// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"
#include "option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Operations";

} // namespace

void declareOperations(CLI::App& mill, MillCommand& command)
{
  MillOptions& o = command.options;
  choice(mill,
         "--roughing",
         o.roughing,
         {{"grid", RoughingStrategy::Grid},
          {"zigzag", RoughingStrategy::ZigZag},
          {"spiral", RoughingStrategy::Spiral},
          {"high-speed", RoughingStrategy::HighSpeed},
          {"offset", RoughingStrategy::Offset}},
         "how the roughing goes over a level")
      ->default_str("offset")
      ->group(kGroup);
  numberOption(mill, "--step-down", o.step_down, "MM", "of the roughing; 0: 0.3 d / 4")
      ->group(kGroup);
  numberOption(mill, "--step-over", o.step_over, "MM", "of the roughing; 0: 0.4 d")
      ->group(kGroup);
  mill.add_option("--rest-tool",
                  command.rest_diameter,
                  "diameter of a flat end mill, T4, that cuts what the roughing tool "
                  "left before the ball end mills do")
      ->type_name("MM")
      ->group(kGroup);
  mill.add_option("--min-flat",
                  o.min_flat,
                  "smallest level ground that gets a level of the roughing; 0: none")
      ->type_name("MM2")
      ->default_str("the diameter of the tool's end squared")
      ->group(kGroup);
  choice(mill,
         "--raster",
         o.raster,
         {{"x", RasterDirection::AlongX},
          {"y", RasterDirection::AlongY},
          {"auto", RasterDirection::Auto}},
         "the finishing rows run along; auto: whichever is milled sooner")
      ->default_str("auto")
      ->group(kGroup);
  choice(mill,
         "--pattern",
         o.pattern,
         {{"zigzag", RasterPattern::ZigZag}, {"one-way", RasterPattern::OneWay}},
         "how the finishing rows follow each other")
      ->default_str("zigzag")
      ->group(kGroup);
  choice(mill,
         "--milling",
         o.milling,
         {{"climb", MillingMode::Climb}, {"conventional", MillingMode::Conventional}},
         "of one-way rows, for a spindle that turns clockwise")
      ->default_str("climb")
      ->group(kGroup);
  choice(mill,
         "--boundary",
         o.over_stock,
         {{"part", false}, {"stock", true}},
         "finishing goes wherever the cutter touches the part, or keeps its axis over "
         "the stock")
      ->default_str("part")
      ->group(kGroup);
  mill.add_option("--polygon",
                  command.polygon,
                  "finishing keeps the tool's axis inside this polygon of the part "
                  "frame")
      ->type_name("X Y X Y X Y ...")
      ->expected(6, 20000)
      ->group(kGroup);
  numberOption(mill,
               "--overhang",
               o.overhang,
               "MM",
               "how far beyond stock or polygon the axis may go; negative: inside")
      ->group(kGroup);
  mill.add_option("--threads", o.threads, "0: all of the machine")
      ->capture_default_str()
      ->group(kGroup);
}
