// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "word_printer.h"

#include "arc_geometry.h"

namespace pointmill::gcode {

namespace {

constexpr char centre_letters[] = {'I', 'J', 'K'};

} // namespace

void WordPrinter::forget()
{
  mode_ = Mode::None;
  at_.reset();
}

void WordPrinter::approached(const MachinePosition& to)
{
  mode_ = Mode::Rapid;
  at_ = to;
}

void WordPrinter::traverse(const MachinePosition& to)
{
  if (at_ && to == *at_)
    return;
  endBlock(axes(mode(block(), Mode::Rapid), to));
}

void WordPrinter::straight(const MachinePosition& to, std::int64_t rate)
{
  if (at_ && to == *at_)
    return;
  endBlock(feed(axes(mode(block(), Mode::Feed), to), rate));
}

void WordPrinter::arc(const MachineArc& arc, std::int64_t rate)
{
  selectPlane(arc.plane);
  if (post_.absolute_pole)
    writePole(arc);
  char* p = mode(block(), arc.clockwise ? Mode::Clockwise : Mode::CounterClockwise);
  if (post_.absolute_pole) { // both axes, as in the control's manuals
    const auto axis = axesOf(arc.plane);
    along(*at_, axis.u) = along(arc.to, axis.u) + 1;
    along(*at_, axis.v) = along(arc.to, axis.v) + 1;
  }
  p = axes(p, arc.to);
  if (!post_.absolute_pole)
    p = centre(p, arc);
  endBlock(feed(p, rate));
}

char* WordPrinter::mode(char* to, Mode mode)
{
  if (mode == mode_)
    return to;
  mode_ = mode;
  return word(to,
              mode == Mode::Rapid       ? post_.rapid
              : mode == Mode::Feed      ? post_.feed
              : mode == Mode::Clockwise ? post_.arc_cw
                                        : post_.arc_ccw);
}

char* WordPrinter::axes(char* to, const MachinePosition& position)
{
  if (!at_ || position.x != at_->x)
    to = coordinate(to, 'X', position.x);
  if (!at_ || position.y != at_->y)
    to = coordinate(to, 'Y', position.y);
  if (!at_ || position.z != at_->z)
    to = coordinate(to, 'Z', position.z);
  at_ = position;
  return to;
}

void WordPrinter::selectPlane(ArcPlane plane)
{
  if (plane == plane_)
    return;
  plane_ = plane;
  mode_ = Mode::None;
  endBlock(word(block(),
                plane == ArcPlane::XY   ? "G17"
                : plane == ArcPlane::ZX ? "G18"
                                        : "G19"));
}

/// The centre alone, before the arc, in the part frame.
void WordPrinter::writePole(const MachineArc& arc)
{
  const auto axis = axesOf(arc.plane);
  char* p = block();
  p = coordinate(p, centre_letters[axis.u], along(*at_, axis.u) + arc.u);
  p = coordinate(p, centre_letters[axis.v], along(*at_, axis.v) + arc.v);
  endBlock(p);
  mode_ = Mode::None;
}

/// From the start, without what is 0.
char* WordPrinter::centre(char* to, const MachineArc& arc) const
{
  const auto axis = axesOf(arc.plane);
  for (int i = 0; i < 3; ++i) {
    const std::int64_t offset = i == axis.u ? arc.u : i == axis.v ? arc.v : 0;
    if (offset != 0)
      to = coordinate(to, centre_letters[i], offset);
  }
  return to;
}

} // namespace pointmill::gcode
