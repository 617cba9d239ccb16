// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"
#include "option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Machine";

} // namespace

void declareMachine(CLI::App& mill, MillCommand& command)
{
  Machine& machine = command.options.machine;
  const auto add =
      [&](const char* name, double& value, const char* unit, const char* help) {
        numberOption(mill, name, value, unit, help)->group(kGroup);
      };
  add("--rapid-rate", machine.rapid_rate, "MM/MIN", "speed of G0");
  add("--acceleration", machine.acceleration, "MM/S2", "for the time estimate");
  add("--max-feed", machine.max_feed, "MM/MIN", "no feed is faster; 0: not known");
  add("--min-spindle",
      machine.min_spindle,
      "RPM",
      "slowest spindle speed; 0: not known");
  add("--max-spindle",
      machine.max_spindle,
      "RPM",
      "fastest spindle speed; 0: not known");
  add("--power", machine.power, "W", "of the spindle, for --material; 0: not known");
  mill.add_option("--travel", command.travel, "where the tip may be, in the part frame")
      ->type_name("X0 Y0 Z0 X1 Y1 Z1")
      ->expected(6)
      ->group(kGroup);
  mill.add_flag("--no-coolant", command.no_coolant, "no M8")->group(kGroup);
  mill.add_option("--material",
                  command.material,
                  "what the stock is made of: sets spindle speeds and feeds that are "
                  "not given (pointmill cutting --list)")
      ->type_name("NAME")
      ->group(kGroup);
}
