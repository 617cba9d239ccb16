// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "built_in_posts.h"

namespace pointmill::gcode {

namespace {

const char* const linuxcnc = R"(# LinuxCNC 2.8 and newer
name: linuxcnc
control: LinuxCNC
extension: ngc
form: rs274
decimals_mm: 4
decimals_inch: 5
feed_decimals: 3
line_limit: 255
arc_planes: [XY, ZX, YZ]
helix_planes: [XY, ZX, YZ]
tools: changer
retract: machine
unit_mm: G21
unit_inch: G20
setup: |
  G17 {unit} G40 G49 G54 G80 G90 G94
  G91.1
exact_path: G61
# Without Q0 the control also merges short lines within P, on top of the blending.
blend: G64 P{tolerance} Q0.
tool_change: |
  T{tool} M6
  G43 H{tool}
  S{rpm} M3
spindle: S{rpm} M3
coolant_on: M8
coolant_off: M9
approach: |
  G0 Z{z}
  G0 X{x} Y{y}
dwell: G4 P{seconds}
stop: M5 M9
# Machine coordinates: before the first tool change the program knows neither where the
# tool is nor how long it is, so no height of the part frame is known to be safe.
retract_machine: G53 G0 Z0.
retract_home: |
  G28 G91 Z0.
  G90
end: M30
)";

const char* const grbl =
    R"(# Grbl 1.1: no tool changer, no tool length, exact path always
name: grbl
control: Grbl 1.1
extension: nc
form: grbl
decimals_mm: 3
decimals_inch: 4
feed_decimals: 2
# Blanks not counted, it is 79.
line_limit: 79
comment_width: 79
# Not ! and ~ and ?, which it obeys anywhere, and not %.
comment_characters: " \"#$&'*-:<->@-}"
arc_planes: [XY, ZX, YZ]
helix_planes: [XY, ZX, YZ]
tools: program
# Where machine zero is depends on homing, which not every machine has; the height of the
# part is known, since the operator has set it for this tool.
retract: clearance
unit_mm: G21
unit_inch: G20
setup: |
  G17 {unit} G54 G90 G94
  G91.1
tool_change: |
  T{tool}
  S{rpm} M3
tool_pause: |
  (Change to {tool_text} and set its length)
  T{tool}
  M0
  S{rpm} M3
spindle: S{rpm} M3
coolant_on: M8
coolant_off: M9
approach: |
  G0 Z{z}
  G0 X{x} Y{y}
dwell: G4 P{seconds}
stop: M5 M9
retract_machine: G53 G0 Z0.
retract_home: |
  G28 G91 Z0.
  G90
end: M30
)";

const char* const mach = R"(# Mach3 and Mach4
base: linuxcnc
name: mach
control: Mach3/4
extension: tap
retract: home
# G64 takes no tolerance here.
blend: ""
)";

const char* const fanuc = R"(# Fanuc 0i, 18i, 30i and their like
name: fanuc
control: Fanuc
extension: nc
form: rs274
decimals_mm: 3
decimals_inch: 4
feed_decimals: 1
upper_case: true
comment_characters: " A-Z0-9.,:=_-"
line_limit: 80
arc_planes: [XY, ZX, YZ]
helix_planes: [XY, ZX, YZ]
tools: changer
retract: home
unit_mm: G21
unit_inch: G20
start: |
  %
  O{number:4} ({program})
setup: |
  G17 {unit} G40 G49 G54 G80 G90 G94
exact_path: G61
tool_change: |
  T{tool} M6
  S{rpm} M3
spindle: S{rpm} M3
coolant_on: M8
coolant_off: M9
approach: |
  G0 G43 Z{z} H{tool}
  G0 X{x} Y{y}
dwell: G4 X{seconds}
stop: |
  M9
  M5
retract_machine: |
  G53 G0 Z0.
  G49
retract_home: |
  G28 G91 Z0.
  G90 G49
end: |
  M30
  %
)";

const char* const haas = R"(# Haas NGC
base: fanuc
name: haas
control: Haas
upper_case: false
comment_characters: " -'*-~"
feed_decimals: 2
retract: machine
start: |
  %
  O{number:5} ({program})
# P3 is smooth finishing, E the largest rounding of a corner.
blend: G187 P3 E{tolerance}
dwell: G4 P{seconds}
retract_machine: G53 G0 Z0.
retract_home: |
  G28 G91 Z0.
  G90
)";

const char* const siemens = R"(# Siemens Sinumerik 840D sl
name: siemens
control: Sinumerik 840D
extension: mpf
form: siemens
decimals_mm: 4
decimals_inch: 5
feed_decimals: 2
decimal_point: false
comment_open: "; "
comment_close: ""
line_limit: 255
number_step: 1
arc_planes: [XY, ZX, YZ]
helix_planes: [XY, ZX, YZ]
tools: changer
retract: machine
# Unlike G71 and G70 these hold for feeds as well.
unit_mm: G710
unit_inch: G700
setup: |
  G17 {unit} G40 G54 G90 G94
exact_path: G60
# In the language itself; CYCLE832 has other parameters in each version of the software.
blend: |
  G642
  CTOL={tolerance}
tool_change: |
  T{tool} D1
  M6
  S{rpm} M3
spindle: S{rpm} M3
coolant_on: M8
coolant_off: M9
approach: |
  G0 Z{z}
  G0 X{x} Y{y}
dwell: G4 F{seconds}
stop: |
  M9
  M5
# Without the work offset and the tool's length.
retract_machine: G0 SUPA Z0 D0
end: M30
)";

const char* const heidenhain = R"(# Heidenhain TNC, conversational
name: heidenhain
control: Heidenhain Klartext
extension: h
form: klartext
decimals_mm: 4
decimals_inch: 5
feed_decimals: 0
# Programs in inches count feeds in tenths of an inch a minute.
inch_feed_factor: 10
plus_sign: true
decimal_point: false
comment_open: "; "
comment_close: ""
upper_case: true
line_limit: 120
arc_planes: [XY, ZX, YZ]
helix_planes: [XY]
tools: changer
retract: machine
unit_mm: MM
unit_inch: INCH
start: BEGIN PGM {program} {unit}
stock: |
  BLK FORM 0.1 Z X{xmin} Y{ymin} Z{zmin}
  BLK FORM 0.2 X{xmax} Y{ymax} Z{zmax}
exact_path: |
  CYCL DEF 32.0 TOLERANCE
  CYCL DEF 32.1 T0
blend: |
  CYCL DEF 32.0 TOLERANCE
  CYCL DEF 32.1 T{tolerance}
tool_change: |
  TOOL CALL {tool} Z S{rpm}
  M3
spindle: TOOL CALL S{rpm}
coolant_on: M8
coolant_off: M9
approach: |
  L Z{z} R0 FMAX
  L X{x} Y{y} R0 FMAX
dwell: |
  CYCL DEF 9.0 DWELL TIME
  CYCL DEF 9.1 DWELL {seconds}
stop: |
  M9
  M5
retract_machine: L Z+0 R0 FMAX M91
end: |
  M30
  END PGM {program} {unit}
)";

const char* const heidenhain_iso = R"(# Heidenhain TNC, DIN/ISO
name: heidenhain-iso
control: Heidenhain ISO
extension: i
form: heidenhain-iso
decimals_mm: 4
decimals_inch: 5
feed_decimals: 0
inch_feed_factor: 10
plus_sign: true
comment_open: "; "
comment_close: ""
upper_case: true
line_limit: 120
numbers: true
rapid: G00
feed: G01
arc_cw: G02
arc_ccw: G03
# Helices are polar here, and G18 and G19 say which axis the spindle is.
arc_planes: [XY]
absolute_pole: true
tools: changer
retract: machine
unit_mm: G71
unit_inch: G70
start: |
  %{program} {unit}
stock: |
  G30 G17 X{xmin} Y{ymin} Z{zmin}
  G31 G90 X{xmax} Y{ymax} Z{zmax}
setup: G17 G40 G90 G94
exact_path: G62 T0
blend: G62 T{tolerance}
tool_change: |
  T{tool} G17 S{rpm}
  M03
coolant_on: M08
coolant_off: M09
approach: |
  G00 Z{z}
  G00 X{x} Y{y}
dwell: G04 F{seconds}
stop: |
  M09
  M05
retract_machine: G00 Z+0 M91
end: |
  M30
  %{program} {unit}
)";

} // namespace

const std::vector<std::pair<std::string, std::string>>& builtInPosts()
{
  static const std::vector<std::pair<std::string, std::string>> posts{
      {"linuxcnc", linuxcnc},
      {"grbl", grbl},
      {"mach", mach},
      {"fanuc", fanuc},
      {"haas", haas},
      {"siemens", siemens},
      {"heidenhain", heidenhain},
      {"heidenhain-iso", heidenhain_iso}};
  return posts;
}

} // namespace pointmill::gcode
