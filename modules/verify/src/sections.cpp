// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

namespace pointmill {

std::vector<ProgramSection> sectionsOf(const Program& program)
{
  std::vector<ProgramSection> sections;
  auto next = program.sections.begin();
  int cutting = 0;           // the tool that cuts in the section, 0: none yet
  std::size_t tool_from = 0; // first move with the present tool
  for (std::size_t k = 0; k < program.moves.size(); ++k) {
    const ProgramMove& m = program.moves[k];
    if (k > 0 && m.tool != program.moves[k - 1].tool)
      tool_from = k;
    bool begins = k == 0;
    ProgramSection section;
    for (; next != program.sections.end() && next->move <= k; ++next) {
      section = *next;
      begins = true;
    }
    if (begins) {
      if (section.line == 0)
        section.line = m.line;
      section.move = k;
      sections.push_back(section);
      cutting = 0;
    }
    if (m.rapid)
      continue;
    if (cutting != 0 && m.tool != cutting)
      sections.push_back({sections.back().name,
                          m.tool,
                          program.moves[tool_from].line,
                          std::max(tool_from, sections.back().move + 1)});
    cutting = sections.back().tool = m.tool;
  }
  return sections;
}

} // namespace pointmill
