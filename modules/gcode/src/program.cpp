// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/gcode/gcode_reader.h>

#include <algorithm>
#include <utility>

namespace pointmill {

void Program::append(Program next, const std::string& name)
{
  files.push_back({name, lines + 1});
  const std::size_t first_move = moves.size();
  moves.reserve(first_move + next.moves.size());
  for (auto m : next.moves) {
    m.line += lines;
    moves.push_back(m);
  }
  for (auto& section : next.sections) {
    section.line += lines;
    section.move += first_move;
    sections.push_back(std::move(section));
  }
  tools.insert(tools.end(), next.tools.begin(), next.tools.end());
  const bool first = files.size() == 1;
  // A file that leaves the blending to the machine leaves it so for all.
  blend = first                         ? next.blend
          : blend < 0 || next.blend < 0 ? -1.0
                                        : std::max(blend, next.blend);
  merge = std::max(merge, next.merge);
  ended = next.ended && (first || ended);
  inches |= next.inches;
  lines += next.lines;
}

std::string Program::where(std::size_t line) const
{
  const auto after = std::upper_bound(
      files.begin(), files.end(), line, [](std::size_t l, const ProgramFile& f) {
        return l < f.first_line;
      });
  if (after == files.begin() || files.size() == 1)
    return "line " + std::to_string(line);
  const ProgramFile& file = *(after - 1);
  return file.name + " line " + std::to_string(line - file.first_line + 1);
}

} // namespace pointmill
