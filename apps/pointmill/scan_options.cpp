// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"
#include "option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Scan";

} // namespace

void declareScan(CLI::App& mill, MillCommand& command)
{
  MillOptions& o = command.options;
  CLI::Option* units_option =
      choice(mill,
             "--units",
             o.mm_per_unit,
             {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}},
             "the scan's units")
          ->default_str("mm")
          ->group(kGroup);
  mill.add_option(
          "--scale", o.mm_per_unit, "mm per unit of the scan, instead of --units")
      ->type_name("S")
      ->excludes(units_option)
      ->group(kGroup);
  mill.add_option("--fit", o.fit, "scale so that the largest extent is this")
      ->type_name("MM")
      ->group(kGroup);
  choice(mill,
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
      ->group(kGroup);
  mill.add_flag("--no-square", command.no_square, "do not turn the long side to X")
      ->group(kGroup);
  choice(mill,
         "--datum",
         o.datum_xy,
         {{"corner", DatumXY::Corner}, {"centre", DatumXY::Centre}},
         "X0 Y0 of the part's bounding box")
      ->default_str("corner")
      ->group(kGroup);
  choice(mill,
         "--datum-z",
         o.datum_z,
         {{"top", DatumZ::Top}, {"bottom", DatumZ::Bottom}},
         "Z0 of the part's bounding box")
      ->default_str("top")
      ->group(kGroup);
  mill.add_flag(
          "--keep-strays", command.keep_strays, "keep points that have no company")
      ->group(kGroup);
  choice(mill,
         "--gaps",
         o.gaps,
         {{"bridge", GapPolicy::Bridge},
          {"keep", GapPolicy::Keep},
          {"mill", GapPolicy::Mill}},
         "holes of the scan: bridged from their rim and not cut below, "
         "left standing, or milled like the outside")
      ->default_str("bridge")
      ->group(kGroup);
  mill.add_option("--through-hole",
                  command.through_holes,
                  "a place of the part frame in a gap that is a hole through the part: "
                  "milled, whatever --gaps says; may be repeated")
      ->type_name("X Y")
      ->type_size(2)
      ->expected(-1)
      ->group(kGroup);
  mill.add_option("--seed", o.seed, "of all random sampling")
      ->capture_default_str()
      ->group(kGroup);
}
