// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill {

/// @brief How far a chord may err from a curve, along its normal [mm].
struct ToleranceBand {
  double inside;  ///< into the part
  double outside; ///< away from it
};

} // namespace pointmill
