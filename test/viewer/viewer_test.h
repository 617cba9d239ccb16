// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/verify/program_time.h>
#include <pointmill/viewer/cut_player.h>

#include <memory>
#include <sstream>
#include <string>

namespace viewer_test {

using namespace pointmill;

/// A block of 40 x 30 x 10 mm, its top at 0.
inline Stock block()
{
  return {{0, 0, -10}, {40, 30, 0}};
}

/// A slot along X by a flat end mill of 6 mm, 4 deep, at Y15; then a groove across by a
/// ball of 4 mm, 2 deep, at X30.
inline std::string twoCuts()
{
  return "G21 G17 G90 G94 G54\n"
         "(Operation 1: slot)\n"
         "T1 M6\nG43 H1\nS8000 M3\n"
         "G0 X-5 Y15\nG0 Z5\n"
         "G1 Z-4 F600\n" // line 8
         "G1 X45\n"      // line 9
         "G0 Z5\nM5\n"
         "(Operation 2: groove)\n"
         "T2 M6\nG43 H2\nS9000 M3\n"
         "G0 X30 Y-5\nG0 Z5\n"
         "G1 Z-2 F600\n"
         "G1 Y35\n" // line 19
         "G0 Z5\nM5\nM2\n";
}

inline std::vector<Tool> tools()
{
  return {Tool::flat(1, 6), Tool::ball(2, 4)};
}

inline std::shared_ptr<const Program> programOf(const std::string& text)
{
  std::istringstream in(text);
  return std::make_shared<Program>(readProgram(in));
}

inline std::vector<double> endsOf(const Program& program)
{
  return programTime(program, Machine()).ends;
}

inline std::shared_ptr<CutPlayer> playerOf(const std::string& text, double cell = 0.25)
{
  const auto program = programOf(text);
  return std::make_shared<CutPlayer>(
      StockField(block(), cell, StockField::Bound::Nominal),
      program,
      endsOf(*program),
      tools());
}

} // namespace viewer_test
