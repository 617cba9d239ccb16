// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstdint>

namespace pointmill_test {

/// @brief Random numbers that are the same with every compiler and library, as those of
/// the standard's distributions are not. A 64-bit linear congruential generator
/// (Knuth's constants), whose high bits are mixed.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed)
  {
    for (int i = 0; i < 4; ++i)
      uniform();
  }

  /// @brief Uniform in [0, 1).
  double uniform()
  {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    const std::uint64_t mixed = (state_ >> 11) ^ (state_ >> 43); // of 53 bits
    return static_cast<double>(mixed) / 9007199254740992.0;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// @brief Mean 0, standard deviation 1, within +-6: the sum of twelve uniform
  /// numbers, which needs no function of the mathematical library.
  double normal()
  {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i)
      sum += uniform();
    return sum;
  }

private:
  std::uint64_t state_;
};

} // namespace pointmill_test
