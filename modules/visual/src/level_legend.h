// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "key.h"
#include "level_moves.h"

#include <pointmill/visual/level_picture.h>

namespace pointmill::visual {

/// @brief Says what the colours of a level's picture mean: those that it shows.
/// @param unit [px] that all sizes follow; a text is twice as high
Key levelLegend(
    const LevelScene& scene, const LevelMoves& moves, double z, int room, int unit);

} // namespace pointmill::visual
