// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <vector>

namespace bench {

/// @brief A part that is roughed, as a height over the ground plan [mm].
struct RoughPart {
  const char* name;                     ///< in figures and names of files
  const char* title;                    ///< for people
  double length, width;                 ///< along X and Y, from (0, 0) on [mm]
  double (*height)(double x, double y); ///< NaN beside the part
  double margin; ///< stock beyond the part on each side in X and Y [mm]
};

/// @brief The five parts on which the strategies are compared.
const std::vector<RoughPart>& roughParts();

/// @brief A large plate, 160 x 150 x 29 mm, with bosses, ribs and pockets.
const RoughPart& largePlate();

/// @brief A layer like that of paper 001: a boss on 60 x 60 mm, 1 mm high.
const RoughPart& layerPart();

} // namespace bench
