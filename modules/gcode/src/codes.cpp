// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "codes.h"

#include "block.h"

#include <cstddef>

namespace pointmill::gcode {

namespace {

const char* const group_names[] = {"motion",
                                   "plane",
                                   "distance mode",
                                   "arc distance mode",
                                   "feed mode",
                                   "units",
                                   "cutter compensation",
                                   "tool length",
                                   "work offset",
                                   "path mode",
                                   "non-modal",
                                   "program stop",
                                   "tool change",
                                   "spindle",
                                   "coolant"};

struct Named {
  int first, last; // tenths
  const char* name;
};

constexpr Named other_g[] = {{50, 54, "spline"},
                             {70, 70, "lathe diameter mode"},
                             {80, 80, "lathe radius mode"},
                             {100, 109, "setting of offsets and tools"},
                             {171, 191, "second plane"},
                             {280, 289, "return to a reference point"},
                             {300, 309, "return to a reference point"},
                             {330, 331, "spindle-synchronised motion"},
                             {380, 389, "probing"},
                             {410, 429, "cutter compensation"},
                             {431, 439, "dynamic tool length"},
                             {591, 593, "work offset beyond G59"},
                             {730, 749, "canned drilling"},
                             {760, 769, "threading"},
                             {810, 810, "canned drilling"},
                             {811, 899, "canned cycle"},
                             {901, 901, "absolute arc centres"},
                             {920, 929, "coordinate offset"},
                             {930, 930, "inverse time feed"},
                             {950, 950, "feed per revolution"},
                             {960, 979, "constant surface speed"},
                             {980, 999, "return level of canned cycles"}};

constexpr Named other_m[] = {{70, 70, "mist coolant"},
                             {190, 190, "spindle orientation"},
                             {480, 539, "overrides"},
                             {600, 600, "pallet change"},
                             {610, 619, "setting of the tool number"},
                             {620, 689, "inputs and outputs"},
                             {700, 739, "saving of modal state"},
                             {980, 999, "subprogram"},
                             {1000, 1999, "user command"}};

template <std::size_t N>
const char* nameOf(int tenths, const Named (&names)[N])
{
  for (const auto& n : names)
    if (tenths >= n.first && tenths <= n.last)
      return n.name;
  return nullptr;
}

} // namespace

const char* groupName(Group group)
{
  return group_names[group];
}

Group groupOfG(int tenths)
{
  switch (tenths) {
  case 0:
  case 10:
  case 20:
  case 30:
  case 800:
    return MotionMode;
  case 40:
  case 530:
    return NonModal;
  case 170:
  case 180:
  case 190:
    return Plane;
  case 200:
  case 210:
    return Units;
  case 400:
    return Compensation;
  case 430:
  case 490:
    return Length;
  case 540:
  case 550:
  case 560:
  case 570:
  case 580:
  case 590:
    return Offset;
  case 610:
  case 611:
  case 640:
    return PathMode;
  case 900:
  case 910:
    return Distance;
  case 911:
    return ArcDistance;
  case 940:
    return FeedMode;
  default:
    return NoGroup;
  }
}

Group groupOfM(int tenths)
{
  switch (tenths) {
  case 0:
  case 10:
  case 20:
  case 300:
    return Stop;
  case 30:
  case 40:
  case 50:
    return Spindle;
  case 60:
    return ToolChange;
  case 80:
  case 90:
    return Coolant;
  default:
    return NoGroup;
  }
}

std::string refusal(char letter, int tenths)
{
  const char* const name =
      letter == 'G' ? nameOf(tenths, other_g) : nameOf(tenths, other_m);
  return codeName(letter, tenths) +
         (name ? std::string(" (") + name + ") is not supported" : " is not known");
}

} // namespace pointmill::gcode
