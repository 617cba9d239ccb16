// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill {

/// @brief On which side of a tool that turns clockwise (M3, seen from above) the
/// material of what is left stands, looking along the feed. Climb: on the right, the
/// edges come down through the chip from its thick end. Conventional: on the left.
enum class MillingMode { Climb, Conventional };

} // namespace pointmill
