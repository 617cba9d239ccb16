// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/machine.h>
#include <pointmill/gcode/gcode_reader.h>

#include <cstddef>
#include <vector>

namespace pointmill {

/// @brief How fast the control goes round corners.
enum class CornerMode {
  Program,  ///< as its G61 or G64 says, see programTime()
  Machine,  ///< by Machine::junction_deviation whatever the program says, as Grbl does
  ExactStop ///< it stops at every corner
};

struct ProgramTimeOptions {
  CornerMode corners = CornerMode::Program;
  double tool_change = 15.0; ///< one change, with all that belongs to it [s]

  /// @brief Throws ParameterError.
  void validate() const;
};

/// @brief Seconds that a stretch of a program takes.
struct SectionTime {
  double cutting = 0.0;     ///< feed moves
  double rapid = 0.0;       ///< G0
  double tool_change = 0.0; ///< before its first move, or on the way
  /// Length over feed of all moves alone, as if speed could change at once.
  double unhindered = 0.0;
  /// Moves that count nothing: from or to where the program does not determine.
  std::size_t unknown_moves = 0;

  double total() const { return cutting + rapid + tool_change; }
  SectionTime& operator+=(const SectionTime& other);
};

struct ProgramTime {
  SectionTime total;
  /// One for each of Program::sections, in their order; one where there are none.
  std::vector<SectionTime> sections;
  /// For each move the seconds from the program's start to the move's end.
  std::vector<double> ends;
};

/// @brief Estimates how long a program runs: every move speeds up and brakes with
/// Machine::acceleration along the path, cruises at its feed (a rapid at
/// Machine::rapid_rate), and passes each corner at the speed that it allows. Feeds are
/// kept below Machine::max_feed, where that is not known below the rapid rate.
///
/// A corner is passed as if on a circle that both moves touch, at no more than
/// `sqrt(acceleration radius)`; one move's touches it in the middle of the shorter one
/// at the farthest, so that chords of an arc are milled at the speed of that arc. Nor
/// does the circle leave the corner by more than the deviation that is allowed: P of
/// G64, else Machine::junction_deviation. At deviation 0 (G61, G61.1) the tool stops at
/// each corner, but not between the chords of one arc. It rests, too, where tool or
/// spindle change and at places that the program does not determine.
///
/// Rapids are taken as straight, at the rapid rate along their way, which is the
/// longest that they take. Not counted: jerk, dwells, the run-up of the spindle,
/// and moves to or from the top of the machine. Time and memory are linear in the
/// moves.
///
/// Sources: S. Jeon, Improving Grbl: Cornering Algorithm (2011), the junction
/// deviation; Klipper's documentation, Kinematics, the circle to the middle of the
/// shorter move; a pass forward and one backward as in both.
/// @throws ParameterError for a machine or options that are refused, DataError for a
/// feed move without a feed
ProgramTime programTime(const Program& program,
                        const Machine& machine,
                        const ProgramTimeOptions& options = {});

} // namespace pointmill
