// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "search.h"

#include "search_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define POINTMILL_X86
#include <immintrin.h>
#endif

namespace pointmill {
namespace {

struct Move {
  double ax, ay, az, dx, dy, dz; // start, and from there to the end
};

} // namespace

#ifdef POINTMILL_X86

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw")
namespace avx512 {
namespace {
constexpr int kLanes = 16;
template <typename V>
inline unsigned bitsOf(V v)
{
  return static_cast<unsigned>(_mm512_movepi32_mask((__m512i)v));
}
#include "search.inl"
} // namespace
} // namespace avx512
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
namespace {
constexpr int kLanes = 8;
template <typename V>
inline unsigned bitsOf(V v)
{
  return static_cast<unsigned>(_mm256_movemask_ps((__m256)v));
}
#include "search.inl"
} // namespace
} // namespace avx2
#pragma GCC pop_options

#endif

namespace plain {
namespace {
constexpr int kLanes = 4;
template <typename V>
inline unsigned bitsOf(V v)
{
  unsigned bits = 0;
  for (int k = 0; k < kLanes; ++k)
    bits |= v[k] ? 1u << k : 0u;
  return bits;
}
#include "search.inl"
} // namespace
} // namespace plain

const std::vector<Search>& searches()
{
  static const std::vector<Search> all = [] {
    std::vector<Search> found{
        {"plain", plain::dropRow, plain::dropAlong, plain::gouge}};
#ifdef POINTMILL_X86
    if (__builtin_cpu_supports("avx2"))
      found.push_back({"avx2", avx2::dropRow, avx2::dropAlong, avx2::gouge});
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
      found.push_back({"avx512", avx512::dropRow, avx512::dropAlong, avx512::gouge});
#endif
    return found;
  }();
  return all;
}

} // namespace pointmill
