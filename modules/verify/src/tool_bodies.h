// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <vector>

namespace pointmill {

/// @brief A part of a tool that does not cut: a cylinder from so high above the tip
/// upwards, without end [mm].
struct ToolBody {
  const char* code; ///< of the finding if it touches anything
  double above, radius;

  Tool asTool() const { return Tool::flat(1, 2 * radius); }
};

/// @brief Shank and holder, as far as they are known. A shank no wider than the cutter
/// is left out: it only goes where flutes have been, or the layer was thicker than
/// these are long.
inline std::vector<ToolBody> bodiesOf(const Tool& tool)
{
  std::vector<ToolBody> bodies;
  if (tool.shank_diameter > tool.diameter)
    bodies.push_back({"shank", tool.flute_length, tool.shank_diameter / 2});
  if (tool.holder_diameter > 0)
    bodies.push_back({"holder", tool.stick_out, tool.holder_diameter / 2});
  return bodies;
}

} // namespace pointmill
