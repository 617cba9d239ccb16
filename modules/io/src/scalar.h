// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pointmill::detail {

/// @brief The kinds of numbers that binary files hold.
enum class Scalar { I8, U8, I16, U16, I32, U32, I64, U64, F32, F64 };

inline std::size_t sizeOf(Scalar type)
{
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<int>(type)];
}

/// @brief A little-endian (this machine's order) or, with @p swap, big-endian number.
template <typename T>
T loadAs(const char* from, bool swap = false)
{
  char bytes[sizeof(T)];
  if (swap)
    std::reverse_copy(from, from + sizeof(T), bytes);
  else
    std::memcpy(bytes, from, sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// @brief Exact but for 64-bit integers beyond 2^53.
inline double load(Scalar type, const char* from, bool swap = false)
{
  switch (type) {
  case Scalar::I8:
    return loadAs<std::int8_t>(from);
  case Scalar::U8:
    return loadAs<std::uint8_t>(from);
  case Scalar::I16:
    return loadAs<std::int16_t>(from, swap);
  case Scalar::U16:
    return loadAs<std::uint16_t>(from, swap);
  case Scalar::I32:
    return loadAs<std::int32_t>(from, swap);
  case Scalar::U32:
    return loadAs<std::uint32_t>(from, swap);
  case Scalar::I64:
    return static_cast<double>(loadAs<std::int64_t>(from, swap));
  case Scalar::U64:
    return static_cast<double>(loadAs<std::uint64_t>(from, swap));
  case Scalar::F32:
    return loadAs<float>(from, swap);
  case Scalar::F64:
    return loadAs<double>(from, swap);
  }
  return 0.0;
}

} // namespace pointmill::detail
