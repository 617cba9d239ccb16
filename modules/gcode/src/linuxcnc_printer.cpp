// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "linuxcnc_printer.h"

#include "comment_text.h"

#include <pointmill/common/version.h>

namespace pointmill::gcode {

namespace {

char* word(char* to, const char* line, char letter)
{
  if (to != line)
    *to++ = ' ';
  *to++ = letter;
  return to;
}

} // namespace

void LinuxCncPrinter::begin(const ProgramHead& head)
{
  comment(std::string("PointMill ") + version + " for LinuxCNC");
  for (const auto& text : head.comments)
    comment(text);
  for (const auto& tool : head.tools)
    comment(tool.describe());
  lines_.line("G17 G21 G40 G49 G54 G80 G90 G94");
  lines_.line("G91.1");
  const DecimalGrid grid(6);
  if (const auto tolerance = grid.nearest(head.path_tolerance)) {
    // Without Q0 the control also merges short lines within P, on top of the blending.
    char text[DecimalGrid::max_chars];
    const char* const end = grid.write(text, tolerance);
    lines_.line("G64 P" + std::string(static_cast<const char*>(text), end) + " Q0.");
  }
  else
    lines_.line("G61");
}

void LinuxCncPrinter::comment(const std::string& text)
{
  for (const auto& line : commentLines(text))
    lines_.line("(" + line + ")");
}

void LinuxCncPrinter::stop()
{
  lines_.line("M5 M9");
}

void LinuxCncPrinter::retract()
{
  // Machine coordinates: before the first tool change the program knows neither where
  // the tool is nor how long it is, so no height of the part frame is known to be safe.
  lines_.line("G53 G0 Z0.");
  mode_ = 0;
  at_.reset();
}

void LinuxCncPrinter::changeTool(int number)
{
  const auto n = std::to_string(number);
  lines_.line("T" + n + " M6");
  lines_.line("G43 H" + n);
  mode_ = 0;
  feed_ = 0;
  at_.reset();
}

void LinuxCncPrinter::spindle(long rpm)
{
  lines_.line("S" + std::to_string(rpm) + " M3");
}

void LinuxCncPrinter::coolant(bool on)
{
  lines_.line(on ? "M8" : "M9");
}

void LinuxCncPrinter::approach(const MachinePosition& to)
{
  char* const line = lines_.line();
  char* p = line;
  for (const char c : {'G', '0', ' ', 'Z'})
    *p++ = c;
  lines_.endLine(grid_.write(p, to.z));

  // X and Y both, whatever they were.
  at_ = MachinePosition{to.x + 1, to.y + 1, to.z};
  mode_ = 0;
  move('0', to, 0);
}

void LinuxCncPrinter::traverse(const MachinePosition& to)
{
  move('0', to, 0);
}

void LinuxCncPrinter::straight(const MachinePosition& to, std::int64_t feed)
{
  move('1', to, feed);
}

void LinuxCncPrinter::move(char mode, const MachinePosition& to, std::int64_t feed)
{
  char* const line = lines_.line();
  char* p = line;
  if (mode != mode_) {
    p = word(p, line, 'G');
    *p++ = mode;
    mode_ = mode;
  }
  if (!at_ || to.x != at_->x)
    p = grid_.write(word(p, line, 'X'), to.x);
  if (!at_ || to.y != at_->y)
    p = grid_.write(word(p, line, 'Y'), to.y);
  if (!at_ || to.z != at_->z)
    p = grid_.write(word(p, line, 'Z'), to.z);
  if (mode == '1' && feed != feed_) {
    p = feed_grid_.write(word(p, line, 'F'), feed);
    feed_ = feed;
  }
  lines_.endLine(p);
  at_ = to;
}

void LinuxCncPrinter::end()
{
  lines_.line("M30");
  lines_.flush();
}

} // namespace pointmill::gcode
