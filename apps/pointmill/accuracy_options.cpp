// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"
#include "option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Accuracy";

} // namespace

void declareAccuracy(CLI::App& mill, MillCommand& command)
{
  MillOptions& o = command.options;
  numberOption(
      mill, "--tolerance", o.tolerance, "MM", "deepest gouge, all errors together")
      ->group(kGroup);
  numberOption(mill, "--scallop", o.scallop, "MM", "scallop height of the finishing")
      ->group(kGroup);
  numberOption(mill,
               "--semi-scallop",
               o.semi_scallop,
               "MM",
               "scallop height of the semi-finishing")
      ->group(kGroup);
  choice(mill,
         "--surface",
         o.surface,
         {{"auto", SurfaceChoice::Auto},
          {"points", SurfaceChoice::Points},
          {"smooth", SurfaceChoice::Smooth}},
         "what the cutters rest on: the bare points, or a smooth surface between them "
         "with the noise taken off; auto: by spacing, noise and tolerance")
      ->default_str("auto")
      ->group(kGroup);
  mill.add_option("--noise",
                  o.noise,
                  "the scanner's, a standard deviation; 0: none, so that no point is "
                  "moved")
      ->type_name("MM")
      ->default_str("measured")
      ->group(kGroup);
  mill.add_flag("--accept-sparse",
                o.accept_sparse,
                "go on where tools sink more than the tolerance between bare points")
      ->group(kGroup);
  numberOption(mill,
               "--cell",
               o.cell,
               "MM",
               "edge of a map cell; 0: a twentieth of the roughing tool")
      ->group(kGroup);
  numberOption(mill,
               "--residual-limit",
               o.residual_limit,
               "MM",
               "refuse where half of the points keep more")
      ->group(kGroup);
}
