// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "codes.h"

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
                                   "coolant",
                                   "machine frame"};

// Sets of forms.
constexpr unsigned rs = 1u << static_cast<int>(ProgramForm::Rs274);
constexpr unsigned grbl = 1u << static_cast<int>(ProgramForm::Grbl);
constexpr unsigned siemens = 1u << static_cast<int>(ProgramForm::Siemens);
constexpr unsigned tnc = 1u << static_cast<int>(ProgramForm::HeidenhainIso);
constexpr unsigned all = rs | grbl | siemens | tnc;

struct Known {
  int first, last, step; // tenths
  Group group;
  unsigned forms;
};

constexpr Known known_g[] = {
    {0, 30, 10, MotionMode, all},
    {800, 800, 1, MotionMode, rs | grbl},
    {170, 190, 10, Plane, all},
    {900, 910, 10, Distance, all},
    {901, 901, 1, ArcDistance, rs},
    {911, 911, 1, ArcDistance, rs | grbl},
    {930, 930, 1, FeedMode, rs | grbl | siemens},
    {940, 940, 1, FeedMode, all},
    {200, 210, 10, Units, rs | grbl},
    {700, 710, 10, Units, siemens | tnc},
    {7000, 7100, 100, Units, siemens},
    {400, 400, 1, Compensation, all},
    {430, 430, 1, Length, rs},
    {490, 490, 1, Length, rs | grbl},
    {540, 570, 10, Offset, rs | grbl | siemens},
    {580, 590, 10, Offset, rs | grbl},
    {541, 541, 1, Offset, rs},   // G54.1 P, Fanuc
    {591, 593, 1, Offset, rs},   // LinuxCNC
    {1540, 1540, 1, Offset, rs}, // G154 P, Haas
    {5000, 5000, 1, Offset, siemens},
    {5050, 5990, 10, Offset, siemens},
    {600, 600, 1, PathMode, siemens},
    {610, 610, 1, PathMode, rs | grbl},
    {611, 611, 1, PathMode, rs},
    {620, 620, 1, PathMode, tnc},
    {640, 640, 1, PathMode, rs | siemens},
    {6410, 6420, 10, PathMode, siemens},
    {40, 40, 1, NonModal, all},
    {51, 51, 1, NonModal, rs},     // look-ahead, Fanuc
    {1870, 1870, 1, NonModal, rs}, // smoothness, Haas
    {280, 300, 20, NonModal, rs | grbl},
    {300, 310, 10, NonModal, tnc}, // blank
    {510, 510, 1, NonModal, tnc},  // next tool
    {530, 530, 1, NonModal, rs | grbl | siemens},
    {1530, 1530, 1, NonModal, siemens},
    {920, 921, 1, NonModal, rs | grbl},
    {922, 923, 1, NonModal, rs},
    // Polar coordinates, scaling and rotation off; return level of canned cycles.
    {150, 150, 1, NoEffect, rs},
    {500, 500, 1, NoEffect, rs},
    {690, 690, 1, NoEffect, rs},
    {980, 990, 10, NoEffect, rs},
    // What "in position" means to an exact stop.
    {6010, 6030, 10, NoEffect, siemens}};

constexpr Known known_m[] = {{0, 20, 10, Stop, all},
                             {300, 300, 1, Stop, all},
                             {30, 50, 10, Spindle, all},
                             {130, 140, 10, Spindle, tnc}, // with coolant
                             {60, 60, 1, ToolChange, rs | siemens},
                             {70, 70, 1, Coolant, rs | siemens},
                             {80, 90, 10, Coolant, all},
                             {910, 920, 10, MachineFrame, tnc}};

struct Named {
  int first, last; // tenths
  const char* name;
};

constexpr Named other_g[] = {{50, 54, "spline"},
                             {70, 70, "lathe diameter mode"},
                             {80, 80, "lathe radius mode"},
                             {100, 109, "setting of offsets and tools"},
                             {160, 160, "polar coordinates"},
                             {171, 191, "second plane"},
                             {281, 281, "setting of a reference point"},
                             {301, 301, "setting of a reference point"},
                             {330, 331, "spindle-synchronised motion"},
                             {380, 389, "probing"},
                             {410, 429, "cutter compensation"},
                             {431, 439, "dynamic tool length"},
                             {440, 440, "negative tool length"},
                             {510, 511, "scaling"},
                             {520, 520, "local coordinate system"},
                             {650, 679, "macro"},
                             {680, 689, "rotation"},
                             {730, 749, "canned drilling"},
                             {760, 769, "threading"},
                             {810, 810, "canned drilling"},
                             {811, 899, "canned cycle"},
                             {950, 950, "feed per revolution"},
                             {960, 979, "constant surface speed"}};

constexpr Named other_siemens[] = {{50, 60, "oblique plunge-cutting"},
                                   {330, 359, "threading"},
                                   {410, 429, "cutter compensation"},
                                   {580, 599, "frame"},
                                   {620, 630, "feed override at corners"},
                                   {740, 759, "return to a reference point"},
                                   {950, 950, "feed per revolution"},
                                   {960, 979, "constant cutting rate"},
                                   {1100, 1120, "pole"}};

constexpr Named other_tnc[] = {{50, 69, "arc without direction"},
                               {100, 169, "polar coordinates"},
                               {200, 200, "plane"},
                               {240, 279, "chamfer or rounding"},
                               {280, 280, "mirror image"},
                               {290, 290, "pole at the last position"},
                               {360, 389, "cycle"},
                               {410, 449, "cutter compensation"},
                               {530, 549, "datum shift"},
                               {550, 559, "probing"},
                               {720, 739, "scaling or rotation"},
                               {790, 790, "cycle call"},
                               {980, 980, "label"},
                               {990, 990, "tool definition"},
                               {2000, 2999, "cycle"}};

constexpr Named other_m[] = {{190, 190, "spindle orientation"},
                             {480, 539, "overrides"},
                             {600, 600, "pallet change"},
                             {610, 619, "setting of the tool number"},
                             {620, 689, "inputs and outputs"},
                             {700, 739, "saving of modal state"},
                             {970, 999, "subprogram"},
                             {1000, 1999, "user command"}};

template <std::size_t N>
const char* nameOf(int tenths, const Named (&names)[N])
{
  for (const auto& n : names)
    if (tenths >= n.first && tenths <= n.last)
      return n.name;
  return nullptr;
}

const char* nameOf(ProgramForm form, char letter, int tenths)
{
  if (letter == 'M')
    return nameOf(tenths, other_m);
  if (form == ProgramForm::Siemens)
    return nameOf(tenths, other_siemens);
  if (form == ProgramForm::HeidenhainIso)
    return nameOf(tenths, other_tnc);
  return nameOf(tenths, other_g);
}

template <std::size_t N>
void fill(std::array<Group, 10000>& table, const Known (&codes)[N], unsigned forms)
{
  table.fill(NoGroup);
  for (const auto& code : codes)
    for (int tenths = code.first; tenths <= code.last; tenths += code.step)
      if (code.forms & forms)
        table[static_cast<std::size_t>(tenths)] = code.group;
}

} // namespace

const char* groupName(Group group)
{
  return group_names[group];
}

const char* formName(ProgramForm form)
{
  switch (form) {
  case ProgramForm::Grbl:
    return "Grbl";
  case ProgramForm::Siemens:
    return "Siemens";
  case ProgramForm::HeidenhainIso:
    return "Heidenhain ISO";
  case ProgramForm::Klartext:
    return "Klartext";
  default:
    return "RS-274";
  }
}

std::string codeName(char letter, int tenths)
{
  std::string name = letter + std::to_string(tenths / 10);
  if (tenths % 10)
    name += "." + std::to_string(tenths % 10);
  return name;
}

CodeTable::CodeTable(ProgramForm form) : form_(form)
{
  fill(g_, known_g, 1u << static_cast<int>(form));
  fill(m_, known_m, 1u << static_cast<int>(form));
}

std::string CodeTable::refusal(char letter, int tenths) const
{
  const std::string code = codeName(letter, tenths);
  if (const char* const name = nameOf(form_, letter, tenths))
    return code + " (" + name + ") is not supported";
  const CodeTable other(ProgramForm::Rs274);
  const Group group = letter == 'G' ? other.groupOfG(tenths) : other.groupOfM(tenths);
  if (group < group_count)
    return code + " (" + groupName(group) + ") is not a word of " + formName(form_);
  return code + " is not known";
}

} // namespace pointmill::gcode
