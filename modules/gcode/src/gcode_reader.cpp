// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "front_end.h"
#include "line_reader.h"
#include "machine_state.h"

#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>
#include <pointmill/gcode/gcode_reader.h>

#include <algorithm>

namespace pointmill {

using namespace gcode;

namespace {

Program interpret(LineReader& lines,
                  const GCodeReader& reader,
                  const GCodeReader::MoveHandler& handler)
{
  checkRange("GCodeReader", "chord error", reader.getChordError(), "mm", {1e-6, 1});
  checkRange("GCodeReader", "mounted tool", reader.getMountedTool(), "", {0, 999999});
  Program program;
  MachineState machine(
      program, handler, reader.getChordError(), reader.getMountedTool());
  const auto front_end = frontEnd(reader.getForm(), machine);
  std::string_view text;
  bool goes_on = true;
  const WorkStep all({0.0, 1.0});
  while (goes_on && lines.next(text)) {
    all.reach(lines.progress());
    goes_on = front_end->obey(text, lines.lines());
  }
  if (goes_on)
    front_end->finish();
  program.lines = lines.lines();
  return program;
}

} // namespace

Program GCodeReader::read(std::istream& in, const MoveHandler& handler) const
{
  LineReader lines(in);
  return interpret(lines, *this, handler);
}

Program GCodeReader::read(std::istream& in) const
{
  LineReader lines(in);
  std::vector<ProgramMove> moves;
  Program program = interpret(lines, *this, [&](const ProgramMove& m) {
    // Doubling would need three times the memory of a large program; memory that is
    // reserved and not used costs nothing.
    if (moves.size() == moves.capacity()) {
      const auto size = static_cast<double>(moves.size());
      const double share = lines.progress();
      if (size >= 1024 && share > 0.0)
        moves.reserve(static_cast<std::size_t>(size * std::min(1.1 / share, 64.0)) +
                      64);
    }
    moves.push_back(m);
  });
  program.moves = std::move(moves);
  return program;
}

} // namespace pointmill
