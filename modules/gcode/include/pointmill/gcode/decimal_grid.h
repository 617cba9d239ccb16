// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstdint>
#include <string>

namespace pointmill {

/// @brief How numbers are spelled.
struct NumberStyle {
  bool plus = false;        ///< `+10.`
  bool point = true;        ///< `10.` rather than `10`
  bool leading_zero = true; ///< `0.5` rather than `.5`
};

/// @brief Lengths with a fixed count of decimals of their unit, held as integers
/// ("ticks" of 10^-decimals units), so that what is compared is exactly what is
/// printed, in any locale.
class DecimalGrid {
public:
  /// @brief Longest text that write() makes.
  static constexpr int max_chars = 24;

  /// @brief @p decimals 0 .. 6; throws ParameterError.
  /// @param unit what is printed as 1 [mm]: 25.4 for inches
  explicit DecimalGrid(int decimals, double unit = 1.0);

  int decimals() const { return decimals_; }
  /// @return mm
  double value(std::int64_t ticks) const { return double(ticks) / per_mm_; }

  /// @brief Nearest tick, halves upwards. |@p value| <= 1e9 mm, finite.
  std::int64_t nearest(double value) const;

  /// @brief The tick at or above @p value, so that a printed Z never cuts deeper. A
  /// float that stands for a decimal number of this grid is that number: -1.3f is -1.3,
  /// not -1.2999, though the float lies 5e-8 above it.
  std::int64_t atOrAbove(float value) const;

  /// @brief Prints as "10.", "-0.5" or "0." and returns the end: no exponent, no
  /// trailing zeros, no negative zero. Room for max_chars is needed.
  char* write(char* to, std::int64_t ticks, NumberStyle style = {}) const;
  std::string text(std::int64_t ticks, NumberStyle style = {}) const;

private:
  int decimals_;
  std::int64_t scale_; ///< ticks in a unit
  double per_mm_;      ///< ticks in a millimetre
};

} // namespace pointmill
