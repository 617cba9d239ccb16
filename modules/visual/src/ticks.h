// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "plan.h"

#include <string>

namespace pointmill::visual {

/// @brief Room that ticks take beside a plan, in units of its texts' half height.
constexpr int kTicksLeft = 7, kTicksBelow = 3;

/// @brief Frames a plan and marks round millimetres on its left and lower side.
/// @param across,up what runs there, "X" and "Z"
/// @param unit [px] that all sizes follow; a text is twice as high
void drawTicks(Canvas& canvas,
               const Plan& plan,
               const std::string& across,
               const std::string& up,
               int unit);

} // namespace pointmill::visual
