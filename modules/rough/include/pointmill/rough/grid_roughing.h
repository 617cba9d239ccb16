// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief The grid method of paper 000, 3.3.1: from the stock's lower left corner
/// forward along X cell by cell, the next row back, level by level, in cells of the
/// cutter's diameter less half the allowance. In a cell where the part is in the way
/// the tool goes up, if that is less than a step-down, or else aside: the row ends and
/// begins anew beyond the part.
///
/// The cell decides the rows and where moves end, not how near the tool gets to the
/// part: the height of each move is the lowest that is proven over its whole length.
/// The stock's edges are free boundaries, which the tool passes by its radius. The
/// step-over serves what is left beside walls.
class GridRoughing : public LevelRoughing {
public:
  GridRoughing() : LevelRoughing("GridRoughing") {}

  /// @brief Edge of a cell [mm]: 2 R - 0.5 delta, R of the tool's end.
  double cellSize() const { return getTool().endDiameter() - 0.5 * getAllowance(); }

protected:
  void checkParameters() const override;
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;
};

} // namespace pointmill
