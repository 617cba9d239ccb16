// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "level_moves.h"
#include "plan.h"

namespace pointmill::visual {

constexpr Rgb kEntryMove = hex(0xD55E00);
constexpr Rgb kLinkMove = hex(0xE69F00);

/// @brief Thickness of a cut in a picture whose sizes follow @p unit [px].
inline float lineThickness(int unit)
{
  return 0.3f * static_cast<float>(unit);
}

/// @brief Colour of a cut by its order, @p t from 0 (first) to 1: dark violet to light
/// green, ever lighter (after viridis, without its yellow, which is faint on white).
Rgb orderColour(float t);

/// @brief Draws the moves of a level, and a ring where the tool comes down. Entries lie
/// as a band under the cuts, since a ramp runs along the pass that it begins.
/// @param thickness of a cut [px]
void drawMoves(Canvas& canvas,
               const Plan& plan,
               const LevelMoves& moves,
               float thickness);

/// @brief The mark of a place where the tool comes down.
void drawEntry(Canvas& canvas, const Eigen::Vector2f& at, float thickness);

/// @brief A thin dashed line.
void drawRapid(Canvas& canvas,
               const Eigen::Vector2f& from,
               const Eigen::Vector2f& to,
               float thickness);

} // namespace pointmill::visual
