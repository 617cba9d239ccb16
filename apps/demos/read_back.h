// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/gcode/gcode_writer.h>

#include <cstddef>
#include <string>

/// @brief Compares a program of one operation, as it was read back, with the path that
/// it was written from: every move in its place, to the last decimal, with its feed.
/// Before the first and after the last may be rapids only.
/// @return what differs first, empty where nothing does
std::string differenceFrom(const pointmill::CLCloud& path,
                           const pointmill::Program& program,
                           const pointmill::GCodeWriter& writer);

/// @brief How many of the cutting points of @p passes a linked path does not come
/// through, in their order.
std::size_t pointsLeftOut(const pointmill::CLCloud& passes,
                          const pointmill::CLCloud& path);
