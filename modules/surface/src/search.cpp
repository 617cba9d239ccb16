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
typedef float Floats __attribute__((vector_size(4 * kLanes)));
inline unsigned within(Floats value, float limit, Floats distance, float reach)
{
  const __mmask16 high = _mm512_cmp_ps_mask(value, _mm512_set1_ps(limit), _CMP_GE_OQ);
  return _mm512_mask_cmp_ps_mask(high, distance, _mm512_set1_ps(reach), _CMP_LE_OQ);
}
inline float largest(Floats v)
{
  __m256 half[2];
  __builtin_memcpy(half, &v, sizeof half);
  const __m256 eight = _mm256_max_ps(half[0], half[1]);
  const __m128 four =
      _mm_max_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
  const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)));
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
typedef float Floats __attribute__((vector_size(4 * kLanes)));
inline unsigned within(Floats value, float limit, Floats distance, float reach)
{
  const __m256 high = _mm256_cmp_ps(value, _mm256_set1_ps(limit), _CMP_GE_OQ);
  const __m256 near = _mm256_cmp_ps(distance, _mm256_set1_ps(reach), _CMP_LE_OQ);
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(high, near)));
}
inline float largest(Floats v)
{
  const __m128 four =
      _mm_max_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)));
}
#include "search.inl"
} // namespace
} // namespace avx2
#pragma GCC pop_options

#endif

namespace plain {
namespace {
constexpr int kLanes = 4;
typedef float Floats __attribute__((vector_size(4 * kLanes)));
inline unsigned within(Floats value, float limit, Floats distance, float reach)
{
  unsigned bits = 0;
  for (int k = 0; k < kLanes; ++k)
    bits |= unsigned(value[k] >= limit && distance[k] <= reach) << k;
  return bits;
}
inline float largest(Floats v)
{
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
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
