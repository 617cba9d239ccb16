// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "demo.h"

#include <pointmill/rough/grid_roughing.h>
#include <pointmill/rough/high_speed_roughing.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/rough/spiral_roughing.h>
#include <pointmill/rough/waterline_roughing.h>
#include <pointmill/rough/zigzag_roughing.h>

#include <map>
#include <string>

/// @brief One of each strategy of roughing, with their parameters as options.
struct Strategies {
  explicit Strategies(Demo& demo)
  {
    const auto add = [&](const char* name, const char* stage, auto& roughing) {
      named[name] = &roughing;
      demo.parameters(roughing, stage, name);
    };
    add("offset", "LevelRoughing", offset);
    add("zigzag", "LevelRoughing", zigzag);
    add("spiral", "LevelRoughing", spiral);
    add("grid", "LevelRoughing", grid);
    add("high-speed", "HighSpeedRoughing", high_speed);
    add("waterline", "WaterlineRoughing", waterline);
  }
  Strategies(const Strategies&) = delete;
  Strategies& operator=(const Strategies&) = delete;

  pointmill::OffsetRoughing offset;
  pointmill::ZigZagRoughing zigzag;
  pointmill::SpiralRoughing spiral;
  pointmill::GridRoughing grid;
  pointmill::HighSpeedRoughing high_speed;
  pointmill::WaterlineRoughing waterline;
  std::map<std::string, pointmill::LevelRoughing*> named;
};
