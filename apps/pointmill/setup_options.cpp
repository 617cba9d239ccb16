// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "keep_out_option.h"
#include "mill_command.h"
#include "option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Stock and set-up";

} // namespace

void declareSetUp(CLI::App& mill, MillCommand& command)
{
  MillOptions& o = command.options;
  numberOption(mill,
               "--clearance",
               o.clearance,
               "MM",
               "of the clearance plane above the stock and all zones")
      ->group(kGroup);
  numberOption(mill,
               "--stock-margin",
               o.stock_margin,
               "MM",
               "stock beyond the part on each side")
      ->group(kGroup);
  numberOption(mill, "--stock-top", o.stock_top, "MM", "stock above the part")
      ->group(kGroup);
  numberOption(mill, "--stock-bottom", o.stock_bottom, "MM", "stock below the part")
      ->group(kGroup);
  mill.add_option("--stock-box",
                  command.stock_box,
                  "the stock in the part frame, instead of margins round the part")
      ->type_name("X0 Y0 Z0 X1 Y1 Z1")
      ->expected(6)
      ->group(kGroup);
  mill.add_option("--stock-scan",
                  o.stock_scan,
                  "scan of the raw part, a casting say, in the frame and units of SCAN")
      ->type_name("FILE")
      ->group(kGroup);
  mill.add_option("--floor", o.floor, "no tip goes below this Z of the part frame")
      ->type_name("MM")
      ->default_str("the part's lowest point")
      ->group(kGroup);
  mill.add_option("--keep-out",
                  command.keep_out,
                  std::string("where no tool may be, a clamp: ") + kKeepOutSyntax +
                      "; may be repeated")
      ->type_name("ZONE")
      ->group(kGroup);
  numberOption(mill,
               "--keep-out-margin",
               command.keep_out_margin,
               "MM",
               "that tools keep from such zones")
      ->group(kGroup);
}
