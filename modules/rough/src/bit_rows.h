// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace pointmill {

/// @brief Bits that are set in a word.
inline int bitCount(std::uint64_t word)
{
  word -= (word >> 1) & 0x5555555555555555u;
  word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
  word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<int>((word * 0x0101010101010101u) >> 56);
}

/// @brief The lowest bit that is set in a word that is not 0.
inline int lowestBit(std::uint64_t word)
{
  return __builtin_ctzll(word);
}

/// @brief Calls take(word, mask) for the words of a row of bits that hold the bits from
/// @p first to @p last. A take() that returns a bool ends it with false.
/// @return false where it was ended
template <typename Take>
bool forWords(int first, int last, Take&& take)
{
  constexpr auto kAll = ~std::uint64_t{0};
  for (int word = first >> 6; word <= last >> 6; ++word) {
    auto mask = kAll;
    if (word == first >> 6)
      mask &= kAll << (first & 63);
    if (word == last >> 6)
      mask &= kAll >> (63 - (last & 63));
    if constexpr (std::is_same_v<decltype(take(std::size_t{}, mask)), bool>) {
      if (!take(static_cast<std::size_t>(word), mask))
        return false;
    }
    else
      take(static_cast<std::size_t>(word), mask);
  }
  return true;
}

} // namespace pointmill
