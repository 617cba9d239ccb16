// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cstdint>

namespace pointmill::visual {

/// @brief An sRGB colour, 0 .. 1 each.
struct Rgb {
  float r = 0, g = 0, b = 0;

  Rgb operator*(float f) const { return {r * f, g * f, b * f}; }
  Rgb operator+(const Rgb& o) const { return {r + o.r, g + o.g, b + o.b}; }
};

constexpr Rgb hex(std::uint32_t rgb)
{
  return {static_cast<float>((rgb >> 16) & 255) / 255.f,
          static_cast<float>((rgb >> 8) & 255) / 255.f,
          static_cast<float>(rgb & 255) / 255.f};
}

inline Rgb mix(const Rgb& a, const Rgb& b, float t)
{
  return a * (1 - t) + b * t;
}

inline std::uint8_t toByte(float v)
{
  return static_cast<std::uint8_t>(std::clamp(v, 0.f, 1.f) * 255.f + 0.5f);
}

// Operations take turns in these, after the palette of Okabe and Ito, which people with
// any colour vision tell apart; the yellow is darker than theirs, to be seen on white.
constexpr Rgb kOperations[] = {hex(0x0072B2),
                               hex(0xE69F00),
                               hex(0x56B4E9),
                               hex(0xCC79A7),
                               hex(0xBFA500),
                               hex(0x009E73),
                               hex(0xD55E00),
                               hex(0x6A3D9A)};
constexpr int kOperationCount = 8;

constexpr Rgb kRapid = hex(0x1A1A1A);
constexpr Rgb kGap = hex(0xD55E00);
constexpr Rgb kStockEdge = hex(0x7A8794);
constexpr Rgb kMachined = hex(0xDDE3E8);
constexpr Rgb kRawStock = hex(0xA3AEB9);
constexpr Rgb kInk = hex(0x1F2933);
constexpr Rgb kFaintInk = hex(0x66727F);
constexpr Rgb kPage = hex(0xFFFFFF);
constexpr Rgb kCard = hex(0xF3F6F9);
constexpr Rgb kRule = hex(0xD3DAE1);

constexpr Rgb kOccupied = hex(0xC8281E);
constexpr Rgb kFree = hex(0xF6D743);
constexpr Rgb kProtected = hex(0x5B7C99);

/// @brief Colour of a height, @p t from 0 (lowest) to 1: dark blue to pale sand, ever
/// lighter.
inline Rgb heightColour(float t)
{
  constexpr Rgb stops[] = {hex(0x21466E),
                           hex(0x2F6E93),
                           hex(0x5499A8),
                           hex(0x93C0B5),
                           hex(0xD3DBBB),
                           hex(0xF3E6BE)};
  const float s = std::clamp(t, 0.f, 1.f) * 5.f;
  const int i = std::min(static_cast<int>(s), 4);
  return mix(stops[i], stops[i + 1], s - static_cast<float>(i));
}

} // namespace pointmill::visual
