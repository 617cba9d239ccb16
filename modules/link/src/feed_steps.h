// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/common/point_types.h>

#include <vector>

namespace pointmill {

/// @brief Feeds from the fastest down to @p lowest [mm/min], none less than 1 - @p
/// share of the one before; the full feed, the plunge feed and that of ramps are among
/// them.
std::vector<float> feedLadder(const Cutting& cutting, double lowest, double share);

/// @brief Lowers the feeds of a path to those of a ladder, and changes them only where
/// that saves more time than a change is worth: the sum of both is the least possible.
/// Rapids have no feed and keep none.
/// @param share see feedLadder(); in (0, 1)
void stepFeeds(CLCloud& path, const Cutting& cutting, double share);

} // namespace pointmill
