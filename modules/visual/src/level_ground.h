// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "level_moves.h"
#include "plan.h"

#include <pointmill/visual/level_picture.h>

namespace pointmill::visual {

constexpr int kTones = 32; ///< of each channel; more would make the file larger only

constexpr Rgb kPartAbove = hex(0xDE8C84);
constexpr Rgb kStanding = hex(0xE6DEBD);
constexpr Rgb kSwept = hex(0xDEE6EF);
constexpr Rgb kCutAway = hex(0xF7F7F7);

constexpr double kTouch = 1e-6; ///< higher stock than this above a level stands [mm]

/// @brief Draws what the moves of a level are in: the stock with what the tool's end
/// sweeps of it, the part that is above @p z, and its gaps.
void drawGround(Canvas& canvas,
                const Plan& plan,
                const LevelScene& scene,
                const LevelMoves& moves,
                double z);

/// @brief Colour of a gap at a pixel: hatched.
Rgb gapColour(int x, int y);

} // namespace pointmill::visual
