// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/visual/colour.h>

namespace pointmill::visual {

constexpr Rgb kNeverCut = hex(0x9DA5AD);
constexpr Rgb kOutOfReach = hex(0xCDD3D8);

/// @brief Colours of signed deviations: red below, blue above, which people with any
/// colour vision tell apart (after ColorBrewer's RdBu). They are pale up to the
/// tolerance and jump there, so that a map shows at once what keeps it.
struct DeviationScale {
  double tolerance; ///< mm
  double range;     ///< where the colours end, over the tolerance [mm]

  Rgb at(double deviation) const
  {
    constexpr Rgb none = hex(0xF7F4EC);
    constexpr Rgb pale[] = {hex(0xFBE0D2), hex(0xDCEAF3)};
    constexpr Rgb first[] = {hex(0xF09C78), hex(0x8CC0DC)};
    constexpr Rgb last[] = {hex(0x8E0B22), hex(0x0A3A70)};
    const int side = deviation < 0 ? 0 : 1;
    const double size = deviation < 0 ? -deviation : deviation;
    if (size <= tolerance)
      return mix(none, pale[side], static_cast<float>(size / tolerance));
    const double share = (size - tolerance) / (range - tolerance);
    return mix(first[side], last[side], static_cast<float>(std::min(share, 1.0)));
  }
};

} // namespace pointmill::visual
