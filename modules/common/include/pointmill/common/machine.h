// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stock.h>

#include <optional>

namespace pointmill {

/// @brief What a machine tool can do, as far as it is known. 0 or nothing: not known,
/// and not checked.
struct Machine {
  double rapid_rate = 5000.0;       ///< of G0 [mm/min]
  double max_feed = 0.0;            ///< [mm/min]
  double min_spindle = 0.0;         ///< slowest the spindle turns [rev/min]
  double max_spindle = 0.0;         ///< [rev/min]
  double power = 0.0;               ///< at the spindle [W]
  double acceleration = 500.0;      ///< of the axes [mm/s2]
  double junction_deviation = 0.01; ///< sets the speed round corners [mm]
  std::optional<Stock> travel;      ///< where the tip may be, part frame [mm]

  /// @brief Throws ParameterError, naming the field.
  void validate() const;
};

} // namespace pointmill
