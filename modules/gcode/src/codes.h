// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/gcode_reader.h>

#include <array>
#include <cstdint>
#include <string>

namespace pointmill::gcode {

/// @brief Modal groups of the G and M words that are read: one word of each may stand
/// in a block, but for those without effect.
enum Group : std::uint8_t {
  MotionMode,
  Plane,
  Distance,
  ArcDistance,
  FeedMode,
  Units,
  Compensation,
  Length,
  Offset,
  PathMode,
  NonModal,
  Stop,
  ToolChange,
  Spindle,
  Coolant,
  MachineFrame,
  group_count,
  NoEffect = group_count, ///< switches something off that is not read anyway
  NoGroup
};

/// @brief As an error names it, "distance mode".
const char* groupName(Group group);

/// @brief "Grbl", "Siemens"; as an error names it.
const char* formName(ProgramForm form);

/// @brief "G91.1" for ('G', 911).
std::string codeName(char letter, int tenths);

/// @brief The G and M words that a form has.
class CodeTable {
public:
  explicit CodeTable(ProgramForm form);

  /// @brief The group of a code in tenths (G91.1 is 911), or NoGroup.
  Group groupOfG(int tenths) const { return g_[static_cast<std::size_t>(tenths)]; }
  Group groupOfM(int tenths) const { return m_[static_cast<std::size_t>(tenths)]; }

  /// @brief Why a code without a group is refused: "G81 (canned drilling) is not
  /// supported".
  std::string refusal(char letter, int tenths) const;

private:
  ProgramForm form_;
  std::array<Group, 10000> g_, m_;
};

} // namespace pointmill::gcode
