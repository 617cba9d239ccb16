// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/stock_field.h>

#include <vector>

namespace pointmill {

/// @brief Gauges the layer that a tool takes on a short piece of a move.
///
/// What loads a tool is as thick as said on half of the square of an eighth of the
/// diameter, and two cells wide: a wall's last splinter, and the single rows of cells
/// that a cutter's side passes on a steep descent, are high but as good as nothing.
class LayerGauge {
public:
  /// @param lowered by the piece, in any order, a cell as often as it was; @param cell
  /// edge of a cell [mm]
  /// @return thickness of the layer, less than that of its highest splinters [mm]
  double
  thickness(const std::vector<LoweredCell>& lowered, double diameter, double cell);

private:
  std::vector<double> box_, blocks_; // kept for their memory
};

} // namespace pointmill
