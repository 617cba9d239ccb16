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
};

/// @brief Estimates how long a program runs.
/// @throws ParameterError for a machine or options that are refused
ProgramTime programTime(const Program& program,
                        const Machine& machine,
                        const ProgramTimeOptions& options = {});

} // namespace pointmill
