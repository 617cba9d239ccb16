// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

namespace pointmill::gcode {

/// @brief Modal groups of the G and M words that are read: one word of each may stand
/// in a block.
enum Group {
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
  group_count,
  NoGroup = group_count
};

/// @brief As an error names it, "distance mode".
const char* groupName(Group group);

/// @brief The group of a code in tenths (G91.1 is 911), or NoGroup.
Group groupOfG(int tenths);
Group groupOfM(int tenths);

/// @brief Why a code without a group is refused: "G81 (canned drilling) is not
/// supported".
std::string refusal(char letter, int tenths);

} // namespace pointmill::gcode
