// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstdint>

namespace pointmill {

/// @brief Numbers with a fixed count of decimals, held as integers ("ticks" of
/// 10^-decimals), so that what is compared is exactly what is printed, in any locale.
class DecimalGrid {
public:
  /// @brief Longest text that write() makes.
  static constexpr int max_chars = 24;

  /// @brief @p decimals 1 .. 6; throws ParameterError.
  explicit DecimalGrid(int decimals);

  int decimals() const { return decimals_; }
  double value(std::int64_t ticks) const { return double(ticks) / double(scale_); }

  /// @brief Nearest tick, halves upwards. |@p value| <= 1e9, finite.
  std::int64_t nearest(double value) const;

  /// @brief The tick at or above @p value, so that a printed Z never cuts deeper. A
  /// float that stands for a decimal number of this grid is that number: -1.3f is -1.3,
  /// not -1.2999, though the float lies 5e-8 above it.
  std::int64_t atOrAbove(float value) const;

  /// @brief Prints as "10.", "-0.5" or "0." and returns the end: a decimal point
  /// always, no exponent, no trailing zeros, no negative zero. Room for max_chars is
  /// needed.
  char* write(char* to, std::int64_t ticks) const;

private:
  int decimals_;
  std::int64_t scale_;
};

} // namespace pointmill
