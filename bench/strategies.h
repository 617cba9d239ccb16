// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/grid_roughing.h>
#include <pointmill/rough/high_speed_roughing.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/rough/spiral_roughing.h>
#include <pointmill/rough/zigzag_roughing.h>

#include <memory>

namespace bench {

/// @brief One of the roughing strategies that are compared.
struct Strategy {
  const char* name;  ///< in figures and names of files
  const char* title; ///< for people
  std::unique_ptr<pointmill::LevelRoughing> (*make)();
};

template <typename Roughing>
std::unique_ptr<pointmill::LevelRoughing> make()
{
  return std::make_unique<Roughing>();
}

/// A new strategy needs its include and a line here.
inline constexpr Strategy kStrategies[] = {
    {"grid", "grid", make<pointmill::GridRoughing>},
    {"zigzag", "zig-zag", make<pointmill::ZigZagRoughing>},
    {"spiral", "spiral", make<pointmill::SpiralRoughing>},
    {"high-speed", "high-speed", make<pointmill::HighSpeedRoughing>},
    {"offset", "contour-parallel", make<pointmill::OffsetRoughing>},
};

} // namespace bench
