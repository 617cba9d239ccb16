// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_command.h"
#include "option.h"
#include "post_option.h"

using namespace pointmill;

namespace {

const char* const kGroup = "Program";

} // namespace

void declareProgram(CLI::App& mill, MillCommand& command)
{
  GCodeWriter& writer = command.options.writer;
  mill.add_option_function<std::string>(
          "--post",
          [&writer](const std::string& name) { writer.setPost(readPost(name)); },
          "control that is written for: " + postHelp())
      ->type_name("POST")
      ->default_str("linuxcnc")
      ->group(kGroup);
  choice<Unit>(
      mill,
      "--program-units",
      [&writer](Unit unit) { writer.setUnit(unit); },
      {{"mm", Unit::Millimetre}, {"inch", Unit::Inch}},
      "of the program's lengths and feeds")
      ->default_str("mm")
      ->group(kGroup);
  choice<ToolChange>(
      mill,
      "--tool-change",
      [&writer](ToolChange change) { writer.setToolChange(change); },
      {{"changer", ToolChange::Changer},
       {"pause", ToolChange::Pause},
       {"program", ToolChange::Program}},
      "by the machine, by a person while the program waits, or between programs, one "
      "for each tool")
      ->default_str("the post's")
      ->group(kGroup);
  choice<Retract>(
      mill,
      "--retract",
      [&writer](Retract retract) { writer.setRetract(retract); },
      {{"machine", Retract::Machine},
       {"home", Retract::Home},
       {"clearance", Retract::Clearance}},
      "where the tool goes for tool changes and at the end: the top of the machine, "
      "its "
      "reference point, or no higher than the clearance plane")
      ->default_str("the post's")
      ->group(kGroup);
  choice<Corners>(
      mill,
      "--corners",
      [&writer](Corners corners) { writer.setCorners(corners); },
      {{"tolerance", Corners::Tolerance}, {"control", Corners::Control}},
      "rounded within the tolerance, or not at all where the control cannot be told; "
      "or as the control is set, which nothing here can check")
      ->default_str("tolerance")
      ->group(kGroup);
  mill.add_flag("--no-arcs", command.no_arcs, "straight moves only")->group(kGroup);
  mill.add_flag_callback(
          "--line-numbers", [&writer] { writer.setLineNumbers(true); }, "N words")
      ->group(kGroup);
  mill.add_option_function<int>(
          "--max-lines",
          [&writer](int lines) { writer.setMaxLines(lines); },
          "split into complete programs no longer than this")
      ->type_name("N")
      ->group(kGroup);
  mill.add_option_function<int>(
          "--program-number",
          [&writer](int number) { writer.setProgramNumber(number); },
          "O word, for controls that want one")
      ->type_name("N")
      ->group(kGroup);
  mill.add_flag("--force",
                command.options.force,
                "write a program that fails its verification; its head says what is "
                "wrong with it")
      ->group(kGroup);
}
