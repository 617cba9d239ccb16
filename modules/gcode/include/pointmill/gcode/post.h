// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/gcode/machine_calls.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief The unit of a program's lengths.
enum class Unit { Millimetre, Inch };

/// @brief Who changes tools.
enum class ToolChange {
  Changer, ///< the machine, in the program
  Pause,   ///< a person, while the program waits
  Program  ///< a person, between programs: one for each tool
};

/// @brief Where the tool goes before a tool change and at the end.
enum class Retract {
  Machine,  ///< the top of the machine, in its own coordinates
  Home,     ///< the reference point in Z
  Clearance ///< nowhere: it is on the clearance plane, or above it, already
};

/// @brief How a control wants its programs, as a value. The posts that are built in and
/// those that users write are descriptions of one form, YAML; doc/posts.md explains
/// each key, which has the name of the member here. Moves apart, which are spelled by
/// #form, all is templates: lines with places such as {tool}, which is what the control
/// is known for.
struct Post {
  using Lines = std::vector<std::string>;

  std::string name;
  std::string control;   ///< for people, as "LinuxCNC"
  std::string extension; ///< of its files, as "ngc"
  /// @brief How it is read back; Klartext is also what moves are spelled in.
  ProgramForm form = ProgramForm::Rs274;

  /// @name Numbers
  /// @{
  int decimals_mm = 4;   ///< of coordinates, 3 .. 6
  int decimals_inch = 5; ///< 4 .. 6
  int feed_decimals = 3; ///< 0 .. 3
  /// What feeds are multiplied by in programs in inches.
  double inch_feed_factor = 1.0;
  bool plus_sign = false;    ///< `X+10.` rather than `X10.`
  bool decimal_point = true; ///< `X10.` rather than `X10`
  bool leading_zero = true;  ///< `X0.5` rather than `X.5`
  /// @}

  /// @name Comments
  /// @{
  std::string comment_open = "(";
  std::string comment_close = ")";
  /// Those that may stand in comments, with ranges: "A-Z0-9 .,_-".
  std::string comment_characters = " -~";
  bool upper_case = false; ///< comments and the program's name
  int comment_width = 80;  ///< of a comment's line
  /// @}

  /// @name Blocks
  /// @{
  int line_limit = 255; ///< longest line, its end not counted
  bool numbers = false; ///< N words; Klartext has its own, always
  int number_start = 10;
  int number_step = 10;
  int number_max = 99999; ///< after it they start again
  /// @}

  /// @name Moves
  /// @{
  std::string rapid = "G0", feed = "G1", arc_cw = "G2", arc_ccw = "G3";
  std::vector<ArcPlane> arc_planes;   ///< of arcs that it takes; none: no arcs
  std::vector<ArcPlane> helix_planes; ///< of arcs that move along their axis as well
  double largest_sweep = 180.0;       ///< of one arc [degrees], 1 .. 180
  bool absolute_pole = false;         ///< I J are the centre, in a block of their own
  /// @}

  ToolChange tools = ToolChange::Changer; ///< who changes them, unless told
  Retract retract = Retract::Machine;     ///< unless told

  /// @name Templates
  /// The places are {program}, {number}, {unit}, {control}, of the tool {tool},
  /// {tool_text} and {rpm}, and coordinates.
  /// @{
  std::string unit_mm = "G21", unit_inch = "G20"; ///< what {unit} stands for
  Lines start;                                    ///< before the comments of the head
  Lines stock;       ///< {xmin} .. {zmax}; left out where no stock is known
  Lines setup;       ///< modes
  Lines exact_path;  ///< no blending of corners
  Lines blend;       ///< blending within {tolerance}; none: it cannot state one
  Lines tool_change; ///< a tool, its length and the spindle
  Lines tool_pause;  ///< the same by a person; none: it cannot wait
  Lines spindle;     ///< another speed of the same tool; none: as a tool change
  Lines coolant_on, coolant_off;
  Lines approach; ///< to {x} {y} {z}, Z first; leaves rapid motion in force
  Lines dwell;    ///< {seconds}
  Lines stop;     ///< spindle and coolant off
  Lines retract_machine, retract_home; ///< none: it cannot
  Lines end;
  /// @}

  /// @brief Names of the posts that are built in.
  static const std::vector<std::string>& names();
  /// @brief A post that is built in. Throws ParameterError, with the nearest name.
  static Post named(const std::string& name);
  /// @brief The text that describes a built-in post: where to start one's own.
  static std::string description(const std::string& name);
  /// @brief A user's description: `base:`, the name of a built-in post, and the keys
  /// that differ. Throws DataError as "my.yaml:3: unknown key 'coolent_on'; nearest is
  /// 'coolant_on'".
  static Post fromFile(const std::string& path);
  /// @brief The same from text; @p source names it in errors.
  static Post fromText(const std::string& text, const std::string& source);

  bool takesArcs(ArcPlane plane) const;
  bool takesHelices(ArcPlane plane) const;
  /// @brief The lines of a retract; none where it stays.
  const Lines& retractLines(Retract how) const;
  /// @brief Throws ParameterError for what no control can want.
  void validate() const;
};

} // namespace pointmill
